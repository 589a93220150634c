// The program that decodes files for a reader, which starts it and speaks with it through inherited
// descriptors. Libraries that others maintain parse the files here, so that a file at which one of
// them crashes takes down this process only.
#include "Readers/Decoder/Jobs.h"
#include "Readers/Decoder/Program/PerformJob.h"
#include "Readers/Decoder/Program/Replies.h"

#include <csignal>
#include <cstdio>
#include <new>
#include <stdexcept>

#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

namespace
{

/// Leaves no core file with a patient's data, gains no rights, and ends with the reader.
void Confine()
{
  const rlimit none = { 0, 0 };
  setrlimit(RLIMIT_CORE, &none);
  prctl(PR_SET_DUMPABLE, 0);
  prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  std::signal(SIGPIPE, SIG_IGN);
}

/// Performs jobs until the reader ends.
[[noreturn]] void Serve(varimarch::Replies& replies)
{
  using varimarch::MessageKind;
  replies.Send(MessageKind::Hello, varimarch::DecoderVersion());
  for (;;)
  {
    const std::string job = replies.NextJob();
    try
    {
      varimarch::PerformJob(job, replies);
    }
    catch (const varimarch::ReadCancelled&)
    {
      replies.Send(MessageKind::Cancelled);
    }
    catch (const std::bad_alloc&)
    {
      replies.Send(MessageKind::NoMemory);
    }
    catch (const std::exception& error)
    {
      replies.Send(MessageKind::Fault, error.what());
    }
  }
}

}

int main()
{
  struct stat status = {};
  if (fstat(varimarch::DecoderSocket, &status) != 0 || !S_ISSOCK(status.st_mode))
  {
    std::fprintf(stderr, "varimarch-decode is started by the readers of volume files only.\n");
    return 2;
  }
  Confine();
  try
  {
    varimarch::Replies replies(varimarch::DecoderSocket, varimarch::DecoderMemory);
    Serve(replies);
  }
  catch (const varimarch::ChannelClosed&)
  {
    // The reader has ended, or wants no more.
    _exit(0);
  }
}
