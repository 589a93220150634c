#ifndef Varimarch_March_DrawingStopped_h
#define Varimarch_March_DrawingStopped_h

#include <exception>

namespace varimarch
{

/// The end of a drawing that an observer of the window's vtkCommand::AbortCheckEvent has stopped,
/// which is no error: the image is not wanted any more.
class DrawingStopped : public std::exception
{
public:
  const char* what() const noexcept override { return "The drawing was stopped"; }
};

}

#endif
