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

/// Collects errors and warnings of VTK objects, which would otherwise be printed.
class VARIMARCHVOLUME_EXPORT VtkMessages
{
public:
  VtkMessages();
  ~VtkMessages();
  VtkMessages(const VtkMessages&) = delete;
  void operator=(const VtkMessages&) = delete;

  /// Observes an object, which must not outlive this one.
  void Take(vtkObject* object);

  /// The observer, for objects that pass it on to other objects.
  vtkCallbackCommand* Listener() { return this->listener; }

  /// The messages so far, without file, line and address.
  const std::vector<std::string>& Errors() const { return this->errors; }
  const std::vector<std::string>& Warnings() const { return this->warnings; }

  /// The first error as part of a sentence, or `otherwise` if there is none.
  std::string FirstErrorOr(const std::string& otherwise) const;

private:
  vtkNew<vtkCallbackCommand> listener;
  std::vector<std::string> errors;
  std::vector<std::string> warnings;
};

}

#endif
