#include "Readers/Parsing/VtkMessages.h"

#include "Readers/FileError.h"

#include <vtkCallbackCommand.h>
#include <vtkObjectFactory.h>
#include <vtkOutputWindow.h>

#include <algorithm>
#include <utility>

namespace varimarch
{
namespace
{

/// Passes on all that VTK prints.
class HandledOutput : public vtkOutputWindow
{
public:
  static HandledOutput* New();
  vtkTypeMacro(HandledOutput, vtkOutputWindow);

  void DisplayText(const char* text) override { this->handler({ VtkMessage::Kind::Text, text }); }
  void DisplayErrorText(const char* text) override
  {
    this->handler({ VtkMessage::Kind::Error, text });
  }
  void DisplayWarningText(const char* text) override
  {
    this->handler({ VtkMessage::Kind::Warning, text });
  }
  void DisplayGenericWarningText(const char* text) override { this->DisplayWarningText(text); }

  VtkMessages::Handler handler;
};

vtkStandardNewMacro(HandledOutput);

}

std::string VtkMessage::Sentence() const
{
  std::size_t begin = 0;
  for (const char* const place : { "ERROR: In ", "Warning: In ", "Generic Warning: In " })
  {
    if (this->text.rfind(place, 0) == 0)
    {
      begin = std::min(this->text.find('\n'), this->text.size() - 1) + 1;
    }
  }
  const std::size_t address = this->text.find(" (0x", begin);
  if (address != std::string::npos && address == this->text.find_first_of(" \n", begin))
  {
    const std::size_t end = this->text.find("): ", address);
    begin = end == std::string::npos ? begin : end + 3;
  }
  const std::size_t last = this->text.find_last_not_of(" \n");
  return last == std::string::npos || last < begin ? ""
                                                   : this->text.substr(begin, last + 1 - begin);
}

VtkMessages::VtkMessages()
  : VtkMessages([this](const VtkMessage& message) { this->messages.push_back(message); })
{
}

VtkMessages::VtkMessages(Handler handler)
  : handler(std::move(handler))
{
  this->listener->SetClientData(&this->handler);
  this->listener->SetCallback(
    [](vtkObject*, unsigned long event, void* clientData, void* text)
    {
      if (clientData)
      {
        const bool isError = event == vtkCommand::ErrorEvent;
        (*static_cast<Handler*>(clientData))(
          { isError ? VtkMessage::Kind::Error : VtkMessage::Kind::Warning,
            text ? static_cast<const char*>(text) : "an error without text" });
      }
    });
}

VtkMessages::~VtkMessages()
{
  this->listener->SetClientData(nullptr);
  if (this->outputBefore)
  {
    vtkOutputWindow::SetInstance(this->outputBefore);
  }
}

void VtkMessages::Observe(vtkObject* object)
{
  object->AddObserver(vtkCommand::ErrorEvent, this->listener);
  object->AddObserver(vtkCommand::WarningEvent, this->listener);
}

void VtkMessages::ObserveOutput()
{
  this->outputBefore = vtkOutputWindow::GetInstance();
  vtkNew<HandledOutput> output;
  output->handler = this->handler;
  vtkOutputWindow::SetInstance(output);
}

std::string VtkMessages::FirstErrorOr(const std::string& otherwise) const
{
  const std::vector<std::string> errors = this->Errors();
  if (errors.empty())
  {
    return otherwise;
  }
  // Only the first sentence, without its full stop.
  constexpr std::size_t longest = 200;
  return "the fault " +
    Quoted(errors.front().substr(0, (errors.front() + ' ').find(". ")), longest);
}

std::vector<std::string> VtkMessages::FirstLines(VtkMessage::Kind kind) const
{
  std::vector<std::string> lines;
  for (const VtkMessage& message : this->messages)
  {
    if (message.kind == kind)
    {
      const std::string sentence = message.Sentence();
      lines.push_back(sentence.substr(0, sentence.find('\n')));
    }
  }
  return lines;
}

}
