// Whole images of scenes that have a closed form.

#include "App/AnalyticPictures.h"
#include "Core/Quality/ImageError.h"
#include "Scene/Images/OffscreenView.h"
#include "Scene/Reference/ReferencePicture.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace varimarch;

class AnalyticPicture : public testing::TestWithParam<AnalyticScene>
{
protected:
  ImageError ErrorOf(vtkImageData* picture) const
  {
    return CompareImages(static_cast<const float*>(picture->GetScalarPointer()), this->truth.data(),
      this->truth.size() / 4);
  }

  const AnalyticScene& analytic = GetParam();
  Scene scene = SceneOf(analytic, 32);
  const vtkSmartPointer<vtkImageData> image = ImageOf(analytic);
  const std::vector<float> truth = ClosedFormPicture(analytic, scene);
};

TEST_P(AnalyticPicture, ReferenceMatchesTheClosedForm)
{
  EXPECT_GT(*std::max_element(this->truth.begin(), this->truth.end()), 0.2f);
  const auto picture = DrawReferencePicture(this->scene, this->image, 1e-9);
  // Both images are rounded to floats, whose last bit is 1.5e-5 of 1/255.
  EXPECT_LT(this->ErrorOf(picture.value().image).largest, 2e-5);
}

TEST_P(AnalyticPicture, OfTheMapperTendsToTheClosedForm)
{
  this->scene.render.acceleration = Acceleration::Off;
  this->scene.render.sampleDistanceMm = 0.2;
  OffscreenView view(this->scene, this->image, MapperKind::Varimarch);
  const ImageError coarse = this->ErrorOf(view.FloatImage());
  this->scene.render.sampleDistanceMm = 0.01;
  view.Pipeline().SetRenderOptions(this->scene.render);
  const ImageError fine = this->ErrorOf(view.FloatImage());
  // The order is 1 or better; silhouette pixels and float rounding add noise.
  EXPECT_LT(fine.rootMeanSquare, 1.5);
  EXPECT_LT(fine.rootMeanSquare, 0.2 * coarse.rootMeanSquare + 0.001);
}

INSTANTIATE_TEST_SUITE_P(Every, AnalyticPicture, testing::ValuesIn(AnalyticScenes()),
  [](const auto& info)
  {
    std::string name = info.param.name;
    name.erase(std::remove(name.begin(), name.end(), ' '), name.end());
    return name;
  });
