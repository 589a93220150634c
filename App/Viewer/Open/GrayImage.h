#ifndef Varimarch_Viewer_GrayImage_h
#define Varimarch_Viewer_GrayImage_h

#include "Scene/Volumes/VolumeLoading.h"

#include <QImage>

namespace varimarch
{

/// Converts grey pixels to a QImage that owns its pixels.
inline QImage ImageOf(const GrayPicture& picture)
{
  return QImage(
    picture.pixels.data(), picture.width, picture.height, picture.width, QImage::Format_Grayscale8)
    .copy();
}

}

#endif
