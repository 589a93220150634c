#ifndef Varimarch_Core_Geometry_Viewport_h
#define Varimarch_Core_Geometry_Viewport_h

namespace varimarch
{

/// A rectangle of pixels: what a renderer draws to of its framebuffer, or a part of that.
struct Viewport
{
  int left;
  int bottom;
  int width;
  int height;
};

}

#endif
