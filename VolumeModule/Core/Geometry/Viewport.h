#ifndef Varimarch_Core_Geometry_Viewport_h
#define Varimarch_Core_Geometry_Viewport_h

namespace varimarch
{

/// A rectangle of pixels: the part of a framebuffer that a renderer draws to, or a part of that.
struct Viewport
{
  int left;
  int bottom;
  int width;
  int height;
};

}

#endif
