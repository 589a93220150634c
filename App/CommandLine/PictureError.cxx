#include "PictureError.h"

#include <nlohmann/json.hpp>

namespace varimarch
{

PictureError ErrorOf(
  vtkImageData* picture, vtkImageData* truth, const std::array<double, 3>& background)
{
  const auto* image = static_cast<const float*>(picture->GetScalarPointer());
  const auto* right = static_cast<const float*>(truth->GetScalarPointer());
  const int* size = picture->GetDimensions();
  return { CompareImages(image, right, std::size_t(picture->GetNumberOfPoints())),
    ComparePerceived({ image, right, size[0], size[1], background }) };
}

nlohmann::ordered_json ToJson(const ImageError& error)
{
  return { { "rmse", error.rootMeanSquare }, { "percentile99.9", error.percentile999 },
    { "largest", error.largest } };
}

nlohmann::ordered_json ToJson(const PictureError& error)
{
  return { { "error255", ToJson(error.light) }, { "ssim", error.perceived.structuralSimilarity },
    { "ciede2000",
      { { "mean", error.perceived.meanColorDifference },
        { "percentile99", error.perceived.colorDifference99 } } } };
}

}
