#include "VtkMessages.h"

#include "Messages.h"

#include <vtkLogger.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkOutputWindow.h>

#include <iostream>
#include <regex>
#include <stdexcept>

namespace
{

std::string firstError;

bool isInScope = false;
std::string firstOfScope;

// The message without VTK's "ERROR: In file, line 7" and "vtkClass (0x1234): ".
std::string Sentence(const std::string& message)
{
  static const std::regex decoration(R"(^(ERROR|Warning|Generic Warning): In [^\n]*\n)"
                                     R"((\w+ \(0x[0-9a-f]+\): )?)");
  std::string sentence = std::regex_replace(message, decoration, "");
  sentence.erase(sentence.find_last_not_of(" \n") + 1);
  return sentence;
}

}

/// Prints VTK's warnings, and keeps its first error for ThrowIfVtkReportedError.
class vtkMessageCollector : public vtkOutputWindow
{
public:
  static vtkMessageCollector* New();
  vtkTypeMacro(vtkMessageCollector, vtkOutputWindow);

  void DisplayText(const char* text) override { std::cerr << text; }

  void DisplayErrorText(const char* text) override
  {
    if (isInScope)
    {
      this->KeepInScope(text);
      return;
    }
    // The first error names the cause; later ones are its consequences.
    if (firstError.empty())
    {
      firstError = Sentence(text);
    }
  }

  void DisplayWarningText(const char* text) override
  {
    if (isInScope)
    {
      this->KeepInScope(text);
      return;
    }
    varimarch::PrintMessage("warning: " + Sentence(text));
  }

  void DisplayGenericWarningText(const char* text) override { this->DisplayWarningText(text); }

private:
  void KeepInScope(const char* text)
  {
    if (firstOfScope.empty())
    {
      firstOfScope = Sentence(text);
    }
  }
};

vtkStandardNewMacro(vtkMessageCollector);

namespace varimarch
{

void CollectVtkMessages()
{
  // VTK's log would print the same messages again, with colours and addresses.
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
  vtkNew<vtkMessageCollector> collector;
  vtkOutputWindow::SetInstance(collector);
}

void ThrowIfVtkReportedError()
{
  if (!firstError.empty())
  {
    const std::string error = firstError;
    firstError.clear();
    throw std::runtime_error(error);
  }
}

VtkMessageScope::VtkMessageScope()
{
  isInScope = true;
  firstOfScope.clear();
}

VtkMessageScope::~VtkMessageScope()
{
  isInScope = false;
}

std::string VtkMessageScope::First() const
{
  return firstOfScope;
}

}
