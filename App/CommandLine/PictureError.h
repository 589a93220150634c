#ifndef Varimarch_CommandLine_PictureError_h
#define Varimarch_CommandLine_PictureError_h

#include "Core/Quality/ImageError.h"
#include "Core/Quality/PerceptualError.h"

#include <vtkImageData.h>

#include <nlohmann/json_fwd.hpp>

#include <array>

namespace varimarch
{

/// The numerical and the perceived error of a float image.
struct PictureError
{
  ImageError light;          ///< error of premultiplied RGBA before the background
  PerceptualError perceived; ///< error on the background
};

/// @param truth  a float image of the same size
PictureError ErrorOf(
  vtkImageData* picture, vtkImageData* truth, const std::array<double, 3>& background);

nlohmann::ordered_json ToJson(const ImageError& error);
nlohmann::ordered_json ToJson(const PictureError& error);

}

#endif
