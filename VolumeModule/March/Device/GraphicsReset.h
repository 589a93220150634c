#ifndef Varimarch_March_Device_GraphicsReset_h
#define Varimarch_March_Device_GraphicsReset_h

#include <vtkCommand.h>

#include <stdexcept>

namespace varimarch
{

/// The event of a mapper whose frame is lost because the graphics card was reset. Its graphics
/// resources and the window's context are lost too: only a new context draws again.
constexpr unsigned long GraphicsResetEvent = vtkCommand::UserEvent + 1;

/// The reason why a frame is lost, in one sentence.
class GraphicsReset : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// Checks the current context, as far as the driver can tell. A driver tells each reset once.
/// @throws GraphicsReset if the graphics card was reset, so that what was drawn is lost
void CheckForGraphicsReset();

}

#endif
