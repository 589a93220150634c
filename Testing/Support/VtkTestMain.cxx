#include "Support/ExpectedVtkErrors.h"

#include <vtkLogger.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkOutputWindow.h>

#include <gtest/gtest.h>

#include <iostream>

namespace
{
ExpectedVtkErrors* currentExpectation = nullptr;
}

/// Turns messages that VTK would print into test failures, unless the test expects them.
class CollectingOutputWindow : public vtkOutputWindow
{
public:
  static CollectingOutputWindow* New();
  vtkTypeMacro(CollectingOutputWindow, vtkOutputWindow);

  void DisplayText(const char* text) override { std::cerr << text; }
  void DisplayErrorText(const char* text) override { this->Take(text); }
  void DisplayWarningText(const char* text) override { this->Take(text); }
  void DisplayGenericWarningText(const char* text) override { this->Take(text); }

private:
  void Take(const char* text)
  {
    if (currentExpectation)
    {
      currentExpectation->messages.push_back(text);
    }
    else
    {
      ADD_FAILURE() << "VTK reported: " << text;
    }
  }
};

vtkStandardNewMacro(CollectingOutputWindow);

ExpectedVtkErrors::ExpectedVtkErrors()
{
  currentExpectation = this;
  // VTK also logs each error, in a form that ctest takes for a failure.
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
}

ExpectedVtkErrors::~ExpectedVtkErrors()
{
  currentExpectation = nullptr;
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

int main(int argc, char** argv)
{
  testing::InitGoogleTest(&argc, argv);
  vtkNew<CollectingOutputWindow> window;
  vtkOutputWindow::SetInstance(window);
  const int result = RUN_ALL_TESTS();
  vtkOutputWindow::SetInstance(nullptr);
  return result;
}
