/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "completeTime.H"
#include "endSignal.H"
#include "logBuffer.H"
#include "OFstream.H"
#include "Pstream.H"
#include "PstreamReduceOps.H"
#include "timeDirectories.H"
#include "unwatchedIOdictionary.H"
#include "writtenFiles.H"
#include <csignal>

namespace
{

using namespace Foam;
using namespace timeDirectories;

//- Before Time is constructed, which looks for the latest
const argList& setIncompleteAside(const argList& args)
{
    const fileNameList here(folders(args.path(), args.globalPath()));
    for (const word& name : incomplete(here))
    {
        for (const fileName& folder : here)
        {
            setAside(folder/name);
        }
    }
    addEmpty(args.path(), args.globalPath());
    return args;
}


//- Do what writes, and return what went wrong
template<class Action>
string attempt(const Action& action)
{
    string error;
    FatalError.throwExceptions();
    FatalIOError.throwExceptions();
    try
    {
        action();
    }
    catch (const IOerror& e)
    {
        error = e.ioFileName();
    }
    catch (const Foam::error& e)
    {
        error = e.message();
    }
    FatalError.throwExceptions(false);
    FatalIOError.throwExceptions(false);
    return error;
}

}


void Foam::completeTime::refuse(const string& error) const
{
    if (error.empty())
    {
        return;
    }
    FatalErrorInFunction
        << "Cannot write time " << timeName() << ": " << error.c_str() << nl
        << "    The last complete time is " << last_ << ". Free disk space or quota, or"
        << " check the write permission, then start the run again."
        << exit(FatalError);
}


Foam::fileName Foam::completeTime::directory() const
{
    const IOobject file("incomplete", timeName(), "uniform", *this);
    return fileHandler().objectPath(file, word::null).path().path();
}


bool Foam::completeTime::isMine() const
{
    const auto first = [](const fileName& a, const fileName&) { return a; };
    return returnReduce(marked_, first) != marked_ || Pstream::master();
}


void Foam::completeTime::markDirectory() const
{
    marked_ = directory();
    const bool mine = isMine();

    // A new one gets its name when the mark is in it
    const bool fresh = !isDir(marked_);
    const fileName made(fresh ? aside(marked_) : marked_);

    refuse(!mine ? string() : attempt([&]()
    {
        mkDir(mark(made).path());

        // OpenFOAM writes the state of the function objects last, after write()
        mkDir(mark(made).path()/"functionObjects");
        OFstream os(mark(made));
        os  << "This time directory is incomplete: it is being written, or the"
            << " run was interrupted while writing it. The next run removes it.";
        IOobject::writeEndDivider(os).flush();

        if (!os.good() || (fresh && !mv(made, marked_)))
        {
            FatalIOErrorInFunction(os) << "the disk is full"
            << exit(FatalIOError);
        }
    }));
    returnReduce(true, andOp<bool>());
}


void Foam::completeTime::purge() const
{
    if (written_.empty() || written_.last() != timeName())
    {
        written_.append(timeName());
    }
    while (keep_ && written_.size() > keep_)
    {
        // Not before the new one is complete on all
        returnReduce(true, andOp<bool>());
        for (const fileName& folder : folders(path(), globalPath()))
        {
            setAside(folder/written_.first());
            rmDir(aside(folder/written_.first()), true);
        }
        written_.remove(0);
    }
}


void Foam::completeTime::takePurge()
{
    keep_ = purgeWrite_;
    purgeWrite_ = 0;
}


void Foam::completeTime::readDict()
{
    checkControls();
    const int digits = precision_;
    Time::readDict();
    precision_ = max(precision_, digits);
    takePurge();
}


void Foam::completeTime::takePrecision()
{
    // OpenFOAM takes as many digits as it can where timePrecision is too small for the
    // name of the directory
    precision_ = 6;
    controlDict().readIfPresent("timePrecision", precision_);
    while (precision_ < maxPrecision_ && timeName(startTime_) != last_)
    {
        ++precision_;
    }
    setTime(startTime_, timeIndex());
}


void Foam::completeTime::checkControls() const
{
    const dictionary& dict = controlDict();
    const scalar interval = dict.getOrDefault<scalar>("writeInterval", 1);
    const scalar deltaT = dict.getOrDefault<scalar>("deltaT", 1);
    if (!(interval > 0))
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'writeInterval' is " << interval << "; it must be above 0."
            << " A run that is not to write has one longer than its endTime."
            << exit(FatalIOError);
    }
    const word control(dict.getOrDefault<word>("writeControl", "timeStep"));
    if (control != "timeStep" && interval < deltaT/labelMax)
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'writeInterval' is " << interval << " s, of which a deltaT of "
            << deltaT << " s has more than can be counted. Increase writeInterval."
            << exit(FatalIOError);
    }
    if (deltaT > 0 && value() + deltaT == value())
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'deltaT' is " << deltaT << " s, which is lost in the rounding of"
            << " the present time, " << value() << " s. Increase deltaT."
            << exit(FatalIOError);
    }
}


void Foam::completeTime::watchFiles()
{
    const dictionary& dict = controlDict();
    if (!dict.subOrEmptyDict("OptimisationSwitches").found("fileModificationSkew"))
    {
        // One processor compares times of one disk; with OpenFOAM's 10 s an edit soon
        // after another one would never be seen
        regIOobject::fileModificationSkew = 0;
    }
    if (dict.found("runTimeModifiable"))
    {
        return;
    }

    // OpenFOAM's switch is off, private, and set by reading the entry
    auto& control =
        const_cast<unwatchedIOdictionary&>
        (
            dynamic_cast<const unwatchedIOdictionary&>(dict)
        );
    control.add("runTimeModifiable", true);
    const scalar deltaT = deltaT_;
    Time::readDict();
    deltaT_ = deltaT;

    // OpenFOAM has forgotten the files of controlDict by now
    const unwatchedIOdictionary again
    (
        IOobject
        (
            control.name(), control.instance(), *this,
            IOobject::MUST_READ_IF_MODIFIED, IOobject::NO_WRITE, false
        )
    );
    fileHandler().addWatches(control, again.files());
}


void Foam::completeTime::removeIncomplete() const
{
    const fileNameList here(folders(path(), globalPath()));
    const wordList names(incomplete(here));
    for (const word& name : names)
    {
        scalar value = 0;
        readScalar(name, value);
        if (mag(value - this->value()) < 0.01*deltaTValue())
        {
            word complete("none");
            for (const instant& time : times())
            {
                // The collated file handler keeps the list from before
                if (!names.found(time.name()))
                {
                    complete = time.name();
                }
            }
            FatalIOErrorInFunction(controlDict())
                << "'startTime' is " << name << ", but this time directory is"
                << " incomplete because the run was interrupted while writing"
                << " it." << nl << "    The last complete time is " << complete
                << "; with 'startFrom latestTime' the run continues from it."
                << exit(FatalIOError);
        }
    }
    for (const word& name : names)
    {
        for (const fileName& folder : here)
        {
            rmDir(aside(folder/name), true);
        }
        Info<< "Time directory " << name << " was incomplete (the run was"
            << " interrupted while writing it) and has been removed;"
            << " continuing from " << last_ << nl
            << endl;
    }
}


void Foam::completeTime::checkState() const
{
    const fileName uniform(timePath()/"uniform");
    if (isFile(uniform/"time"))
    {
        // OpenFOAM takes from these files what it finds
        const fileName file(writtenFiles::firstTruncated(uniform));
        if (!file.empty())
        {
            FatalErrorInFunction
                << "file " << file << " is truncated" << exit(FatalError);
        }
    }
    else if (isFile(timePath()/"phi"))
    {
        WarningInFunction
            << "There is no file " << uniform/"time" << ". The run continues from "
            << timePath() << ", but the steps are counted from zero." << endl;
    }
    need("uniform/time");
}


Foam::completeTime::completeTime(const argList& args)
:
    Time(Time::controlDictName, (ignoreOverflow(), setIncompleteAside(args))),
    last_(timeName()),
    keep_(0),
    writes_(true),
    ignoreOverflow_(new ignoreOverflow),
    firstStart_(startTime_),
    firstStartFile_
    (
        IOobject
        (
            "firstStart", timeName(), "uniform", *this,
            IOobject::READ_IF_PRESENT, IOobject::AUTO_WRITE
        )
    )
{
    checkControls();
    watchFiles();
    takePrecision();
    takePurge();

    // A file above the shell's limit (ulimit -f) fails, and does not kill
    std::signal(SIGXFSZ, SIG_IGN);
    endSignal::install();

    logBuffer::install();

    removeIncomplete();
    refuseUncopied(*this);
    checkState();

    // The time to the last bit: the name of its directory has fewer digits
    const IOdictionary state
    (
        IOobject
        (
            "time", timeName(), "uniform", *this,
            IOobject::READ_IF_PRESENT, IOobject::NO_WRITE, false
        )
    );
    scalar value = 0;
    if (state.readIfPresent("value", value) && timeName(value) == timeName())
    {
        setTime(value, timeIndex());
    }
    takeFirstStart();
}


void Foam::completeTime::takeFirstStart()
{
    scalar start = firstStart_;
    firstStartFile_.readIfPresent("value", start);
    if (start < value())
    {
        firstStart_ = start;
    }
    const bool byTime =
        writeControl_ == wcRunTime || writeControl_ == wcAdjustableRunTime;
    if (byTime && firstStart_ != startTime_ && writeInterval_ > 0)
    {
        writeTimeIndex_ =
            label(((value() - firstStart_) + 0.5*deltaT_)/writeInterval_);
    }
    firstStartFile_.set("value", timeName(firstStart_, maxPrecision_));
}


Foam::scalar Foam::completeTime::dividing(const scalar deltaT) const
{
    const scalar left = max
    (
        scalar(0), (writeTimeIndex_ + 1)*writeInterval_ - (value() - firstStart_)
    );
    const scalar number = left/deltaT;
    if (number > labelMax)
    {
        return deltaT;
    }
    const scalar even = left/max(label(1), label(round(number)));
    return min(max(even, 0.2*deltaT), 2.0*deltaT);
}


void Foam::completeTime::setDeltaT(const scalar deltaT, const bool adjust)
{
    if
    (
        !adjust
     || writeControl_ != wcAdjustableRunTime
     || firstStart_ == startTime_
    )
    {
        Time::setDeltaT(deltaT, adjust);
        return;
    }

    // Writes count from the first start, function objects from that of this run
    Time::setDeltaT(dividing(deltaT), false);
    writeControl_ = wcNone;
    adjustDeltaT();
    writeControl_ = wcAdjustableRunTime;
}


void Foam::completeTime::startLoop(const List<double>& sizes) const
{
    ignoreOverflow_.clear();
    endSignal::explainTraps();
    if (!writes_)
    {
        return;
    }
    const string error(writtenFiles::trial(directory().path(), sizes));
    if (!error.empty())
    {
        FatalErrorInFunction
            << "The case cannot be written: " << error.c_str() << nl
            << "    Free disk space or check the write permission, the quota"
            << " and the limit of the shell (ulimit -f)." << exit(FatalError);
    }
}


void Foam::completeTime::endLoop() const
{
    if (writes_ && !writeTime())
    {
        Info<< "Time " << timeName() << " was not written: it is no write time"
            << " (writeControl and writeInterval in system/controlDict)." << nl << nl;
    }
}


void Foam::completeTime::need(const word& file, const word& beside) const
{
    const fileName start(timePath());
    bool written =
        isFile(start/"uniform"/"time")
     && (beside.empty() || isFile(start/beside));
    reduce(written, orOp<bool>());
    const bool found = isFile(start/file);
    if (written && !(found && writtenFiles::complete(start/file)))
    {
        FatalErrorInFunction
            << "file " << start/file
            << (found ? " is truncated" : " is missing") << nl
            << "    The run that wrote " << start << " wrote this file, too."
            << " To start without it, remove it and " << start/"uniform"
            << exit(FatalError);
    }
}


void Foam::completeTime::finish() const
{
    if (!marked_.empty())
    {
        const double begun = highResLastModified(mark(marked_));
        const fileName file(writtenFiles::firstTruncated(marked_, begun));
        if (!file.empty())
        {
            refuse(file + " is truncated");
        }

        // Collated files may come later
        const fileName state
        (
            mark(marked_).path()/"functionObjects"/"functionObjectProperties"
        );
        if (fileHandler().type() == "uncollated" && !isFile(state))
        {
            refuse(state);
        }
        returnReduce(true, andOp<bool>());
        rm(mark(marked_));
        marked_.clear();
        last_ = timeName();
        purge();
    }
}


void Foam::completeTime::writeAside(const word& ending)
{
    writeNow();
    returnReduce(true, andOp<bool>());

    if (isMine())
    {
        const fileName moved(marked_ + '.' + ending);
        rm(mark(marked_));
        rmDir(moved, true);
        if (!mv(marked_, moved))
        {
            FatalErrorInFunction
                << "cannot rename " << marked_ << exit(FatalError);
        }
    }
    marked_.clear();
}


bool Foam::completeTime::run() const
{
    const bool more = Time::run();
    finish();

    const label signal = returnReduce(endSignal::received(), maxOp<label>());
    if (more && signal && stopAt_ != saWriteNow)
    {
        Info<< "--> Signal " << signal << " received: the run writes the next time"
            << " step and ends with status 0" << nl << endl;
        stopAt(saWriteNow);
    }
    return more;
}


Foam::Time& Foam::completeTime::operator++()
{
    // OpenFOAM counts the intervals of the writes from here
    const scalar thisStart = startTime_;
    startTime_ = firstStart_;
    Time::operator++();
    startTime_ = thisStart;

    writeTime_ = writeTime_ && writes_;
    if (writeTime_)
    {
        // Some write before the fields do, fvOptions for example
        markDirectory();
    }
    return *this;
}


void Foam::completeTime::returnTo(const TimeState& state)
{
    if (!marked_.empty())
    {
        if (isMine())
        {
            rmDir(marked_, true);
        }
        marked_.clear();
    }
    TimeState::operator=(state);
}


bool Foam::completeTime::write(const bool valid) const
{
    if (!writeTime())
    {
        return false;
    }
    if (marked_.empty())
    {
        markDirectory();
    }

    const unsigned digits = IOstream::defaultPrecision();
    if (writeFormat() == IOstream::BINARY)
    {
        IOstream::defaultPrecision(max(digits, 17u));
    }
    bool good = false;
    const string error(attempt([&]()
    {
        good = Time::write(valid);
        fileHandler().flush();
    }));
    IOstream::defaultPrecision(digits);

    refuse(error);
    if (!good)
    {
        refuse("a file in " + marked_);
    }
    return true;
}
