#ifndef Varimarch_Readers_VtkMessages_h
#define Varimarch_Readers_VtkMessages_h

#include "VarimarchVolumeModule.h"

#include <vtkNew.h>

#include <string>
#include <vector>

class vtkCallbackCommand;
class vtkObject;

namespace varimarch
{

/// Takes the errors and warnings of VTK objects, which would otherwise be printed.
class VARIMARCHVOLUME_EXPORT VtkMessages
{
public:
  VtkMessages();
  ~VtkMessages();
  VtkMessages(const VtkMessages&) = delete;
  void operator=(const VtkMessages&) = delete;

  /// Listens to an object. It must not outlive these messages.
  void Take(vtkObject* object);

  /// The listener itself, for objects that pass it on to objects of their own.
  vtkCallbackCommand* Listener() { return this->listener; }

  /// What has been said, without file, line and address.
  const std::vector<std::string>& Errors() const { return this->errors; }
  const std::vector<std::string>& Warnings() const { return this->warnings; }

  /// The first error as words for a sentence, or `otherwise` if there is none.
  std::string FirstErrorOr(const std::string& otherwise) const;

private:
  vtkNew<vtkCallbackCommand> listener;
  std::vector<std::string> errors;
  std::vector<std::string> warnings;
};

}

#endif
