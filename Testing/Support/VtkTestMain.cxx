#include "Support/ExpectedVtkErrors.h"

#include <vtkLogger.h>

#include <gtest/gtest.h>

#include <iostream>

using varimarch::VtkMessage;
using varimarch::VtkMessages;

namespace
{

// Prints what is neither an error nor a warning; false for these.
bool PrintPlainText(const VtkMessage& message)
{
  const bool isPlain = message.kind == VtkMessage::Kind::Text;
  std::cerr << (isPlain ? message.text : "");
  return isPlain;
}

}

ExpectedVtkErrors::ExpectedVtkErrors()
  : caught(
      [this](const VtkMessage& message)
      {
        if (!PrintPlainText(message))
        {
          this->messages.push_back(message.text);
        }
      })
{
  this->caught.ObserveOutput();
  // VTK also logs each error, in a form that ctest takes for a failure.
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
}

ExpectedVtkErrors::~ExpectedVtkErrors()
{
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_INFO);
}

std::string ExpectedVtkErrors::Text() const
{
  std::string all;
  for (const std::string& message : this->messages)
  {
    all += message;
  }
  return all;
}

// Turns messages that VTK would print into test failures, unless the test expects them.
int main(int argc, char** argv)
{
  testing::InitGoogleTest(&argc, argv);
  VtkMessages unexpected(
    [](const VtkMessage& message)
    {
      if (!PrintPlainText(message))
      {
        ADD_FAILURE() << "VTK reported: " << message.text;
      }
    });
  unexpected.ObserveOutput();
  return RUN_ALL_TESTS();
}
