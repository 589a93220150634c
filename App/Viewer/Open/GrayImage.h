#ifndef Varimarch_Viewer_GrayImage_h
#define Varimarch_Viewer_GrayImage_h

#include "Scene/SlicePixels.h"

#include <QImage>

namespace varimarch
{

/// A gray picture as one of Qt's, with pixels of its own.
inline QImage ImageOf(const GrayPicture& picture)
{
  return QImage(
    picture.pixels.data(), picture.width, picture.height, picture.width, QImage::Format_Grayscale8)
    .copy();
}

}

#endif
