/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "logBuffer.H"
#include <csignal>
#include <iostream>

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


Foam::logBuffer::int_type Foam::logBuffer::overflow(int_type c)
{
    if
    (
        !traits_type::eq_int_type(c, traits_type::eof())
     && traits_type::eq_int_type
        (
            file_->sputc(traits_type::to_char_type(c)), traits_type::eof()
        )
    )
    {
        say();
    }
    return traits_type::not_eof(c);
}


std::streamsize Foam::logBuffer::xsputn(const char* text, std::streamsize n)
{
    if (file_->sputn(text, n) != n)
    {
        say();
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
    static std::streambuf* const buffer = new logBuffer(std::cout.rdbuf());
    std::cout.rdbuf(buffer);
    std::signal(SIGPIPE, SIG_IGN);
}
