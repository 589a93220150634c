#ifndef Varimarch_March_Device_GraphicsReset_h
#define Varimarch_March_Device_GraphicsReset_h

namespace varimarch
{

/// Checks the current context, as far as the driver can tell.
/// @throws std::runtime_error if the graphics card was reset, so that what was drawn is lost
void CheckForGraphicsReset();

}

#endif
