// The program of libFuzzer. The environment variable VARIMARCH_FUZZ_TARGET names the target, and
// VARIMARCH_FUZZ_SECONDS limits the processor time of this process.
#include "Fuzz/FuzzTarget.h"

#include "Readers/Decoder/DecoderSession.h"
#include "Readers/Parsing/VtkMessages.h"

#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <iostream>
#include <stdexcept>
#include <string>

#include <unistd.h>

namespace
{

/// Prints why a target ends. libFuzzer closes the standard error while it tries inputs, after the
/// first call of this.
void PrintReason(const std::string& reason)
{
  static const int error = dup(STDERR_FILENO);
  dprintf(error, "%s", reason.c_str());
}

/// Ends the program at a message of VTK, which a user would see beside the reader's own.
void AbortAt(const varimarch::VtkMessage& message)
{
  // VTK lets nobody observe the elements of its XML files.
  if (message.text.find("vtkXMLDataElement") == std::string::npos)
  {
    PrintReason("VTK printed: " + message.text + "\n");
    std::abort();
  }
}

const varimarch::FuzzTarget& Target()
{
  static const varimarch::FuzzTarget target = []
  {
    const char* const name = std::getenv("VARIMARCH_FUZZ_TARGET");
    return varimarch::FuzzTargetNamed(name ? name : "");
  }();
  return target;
}

/// Sends the signal at which libFuzzer ends behind the present input, and prints its statistics.
void LimitProcessorTime()
{
  const char* const seconds = std::getenv("VARIMARCH_FUZZ_SECONDS");
  itimerspec time = {};
  time.it_value.tv_sec = seconds ? std::atol(seconds) : 0;
  sigevent event = {};
  event.sigev_notify = SIGEV_SIGNAL;
  event.sigev_signo = SIGUSR1;
  timer_t timer = {};
  if (timer_create(CLOCK_PROCESS_CPUTIME_ID, &event, &timer) != 0 ||
    timer_settime(timer, 0, &time, nullptr) != 0)
  {
    throw std::runtime_error("the system has no timer of processor time");
  }
}

}

extern "C" int LLVMFuzzerInitialize(int*, char***)
{
  PrintReason("");
  static varimarch::VtkMessages messages(&AbortAt);
  messages.ObserveOutput();
  try
  {
    Target();
    LimitProcessorTime();
  }
  catch (const std::exception& error)
  {
    std::cerr << "The fuzz target cannot be run: " << error.what() << '\n';
    std::exit(2);
  }
  // All inputs share a decoder, until one of them ends it.
  static const varimarch::DecoderSession session;
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t byteCount)
{
  try
  {
    Target().run(std::string(reinterpret_cast<const char*>(bytes), byteCount));
  }
  catch (const std::exception& error)
  {
    PrintReason("The target failed: " + std::string(error.what()) + "\n");
    std::abort();
  }
  return 0;
}
