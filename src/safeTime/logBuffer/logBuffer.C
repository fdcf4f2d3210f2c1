/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "logBuffer.H"
#include <csignal>
#include <iostream>

Foam::logBuffer* Foam::logBuffer::installed_ = nullptr;


void Foam::logBuffer::say()
{
    if (!said_)
    {
        said_ = true;
        std::cerr
            << "The log (standard output) cannot be written: the disk is full,"
            << " or the pipe is closed. The run continues without it."
            << std::endl;
    }
}


void Foam::logBuffer::pass(const char* text, std::streamsize n)
{
    if (file_->sputn(text, n) != n)
    {
        say();
    }
}


void Foam::logBuffer::filter(const char c)
{
    line_ += c;
    if (c == '\n')
    {
        const bool begins =
            line_.compare(0, 3, "-->") == 0 || line_.compare(0, 7, "Effect ") == 0;
        warning_ = begins || (warning_ && line_.compare(0, 4, "    ") == 0);

        // All lines of an error, which ends the run
        quiet_ = line_.compare(0, 14, "--> FOAM FATAL") != 0;
        if (warning_)
        {
            pass(line_.data(), line_.size());
        }
        line_.clear();
    }
}


Foam::logBuffer::int_type Foam::logBuffer::overflow(int_type c)
{
    if (!traits_type::eq_int_type(c, traits_type::eof()))
    {
        const char text = traits_type::to_char_type(c);
        xsputn(&text, 1);
    }
    return traits_type::not_eof(c);
}


std::streamsize Foam::logBuffer::xsputn(const char* text, std::streamsize n)
{
    std::streamsize i = 0;
    while (quiet_ && i < n)
    {
        filter(text[i++]);
    }
    if (i < n)
    {
        pass(text + i, n - i);
    }
    return n;
}


int Foam::logBuffer::sync()
{
    if (file_->pubsync())
    {
        say();
    }
    return 0;
}


void Foam::logBuffer::install()
{
    // Not a static object: the standard output is flushed when all are gone
    if (!installed_)
    {
        installed_ = new logBuffer(std::cout.rdbuf());
    }
    std::cout.rdbuf(installed_);
    std::signal(SIGPIPE, SIG_IGN);
}


void Foam::logBuffer::quieten(const bool quiet)
{
    if (installed_)
    {
        std::cout.flush();
        installed_->quiet_ = quiet;
        installed_->line_.clear();
        installed_->warning_ = false;
    }
}
