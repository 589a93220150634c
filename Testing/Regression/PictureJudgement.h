#ifndef Varimarch_Testing_PictureJudgement_h
#define Varimarch_Testing_PictureJudgement_h

#include "Core/Quality/ImageError.h"

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include <array>
#include <string>
#include <vector>

/// Largest RMSE of a picture that passes [1/255]. A picture spoilt by twice as much differs from
/// its baseline by more than this, whatever the error that it has anyway (triangle inequality).
inline constexpr double AllowedRmse = 1.0;

/// Premultiplied RGBA over a background, rounded to bytes RGB.
/// @param size  width and height [pixels]
vtkSmartPointer<vtkImageData> BytesOverBackground(const std::vector<float>& rgba,
  const std::array<int, 2>& size, const std::array<double, 3>& background);

/// The difference of two pictures of bytes RGB of one size.
varimarch::ImageError DifferenceOfBytes(vtkImageData* picture, vtkImageData* baseline);

/// @return what is wrong with a picture, in sentences that name measured and allowed; empty:
/// nothing
std::string FaultsOf(vtkImageData* picture, vtkImageData* baseline, double allowed999);

#endif
