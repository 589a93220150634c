#include "Readers/VtkMessages.h"

#include "Readers/FileError.h"

#include <vtkCallbackCommand.h>
#include <vtkObject.h>

#include <algorithm>

namespace varimarch
{
namespace
{

/// Reduces "ERROR: In file, line 7\nvtkClass (0x1234): text\n\n" to "text".
std::string WithoutPlace(const std::string& message)
{
  const std::size_t address = message.find("): ");
  const std::size_t begin = address == std::string::npos ? 0 : address + 3;
  const std::size_t end = message.find('\n', begin);
  return message.substr(begin, end == std::string::npos ? end : end - begin);
}

}

VtkMessages::VtkMessages()
{
  this->listener->SetClientData(this);
  this->listener->SetCallback(
    [](vtkObject*, unsigned long event, void* clientData, void* text)
    {
      auto* self = static_cast<VtkMessages*>(clientData);
      auto& list = event == vtkCommand::ErrorEvent ? self->errors : self->warnings;
      list.push_back(text ? WithoutPlace(static_cast<const char*>(text)) : "an error without text");
    });
}

VtkMessages::~VtkMessages() = default;

void VtkMessages::Take(vtkObject* object)
{
  object->AddObserver(vtkCommand::ErrorEvent, this->listener);
  object->AddObserver(vtkCommand::WarningEvent, this->listener);
}

std::string VtkMessages::FirstErrorOr(const std::string& otherwise) const
{
  if (this->errors.empty())
  {
    return otherwise;
  }
  // Only the first sentence, without its full stop.
  constexpr std::size_t longest = 200;
  std::string sentence = this->errors.front() + ' ';
  return "the fault " +
    Quoted(sentence.substr(0, std::min(sentence.find(". "), sentence.size() - 1)), longest);
}

}
