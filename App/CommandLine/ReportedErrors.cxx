#include "CommandLine/ReportedErrors.h"

#include "Messages.h"
#include "Readers/Parsing/VtkMessages.h"

#include <vtkLogger.h>

#include <iostream>
#include <stdexcept>
#include <string>
#include <utility>

namespace varimarch
{

namespace
{

std::string firstError;

void Take(const VtkMessage& message)
{
  switch (message.kind)
  {
    case VtkMessage::Kind::Error:
      // The first error names the cause; later ones are its consequences.
      firstError = firstError.empty() ? message.Sentence() : firstError;
      return;
    case VtkMessage::Kind::Warning:
      PrintMessage("warning: " + message.Sentence());
      return;
    case VtkMessage::Kind::Text:
      std::cerr << message.text;
  }
}

}

void CollectVtkMessages()
{
  // VTK's log would print the same messages again, with colours and addresses.
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
  static VtkMessages messages(&Take);
  messages.ObserveOutput();
}

void ThrowIfVtkReportedError()
{
  if (!firstError.empty())
  {
    throw std::runtime_error(std::exchange(firstError, {}));
  }
}

}
