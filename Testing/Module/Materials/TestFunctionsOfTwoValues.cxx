// Transfer functions of two values; the second is the gradient magnitude or another array.

#include "Module/Scenes/LabelledTorso.h"
#include "Module/Scenes/ReferenceMaterials.h"
#include "Support/ExpectedVtkErrors.h"

#include <vtkDataArray.h>
#include <vtkFloatArray.h>
#include <vtkPointData.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace varimarch;

namespace
{

// A function of 5 x 3 points. Red is the position of the first value, green that of the second, and
// the opacity is a tenth of their product.
vtkSmartPointer<vtkImageData> Function()
{
  const auto function = vtkSmartPointer<vtkImageData>::New();
  function->SetDimensions(5, 3, 1);
  function->AllocateScalars(VTK_FLOAT, 4);
  for (int y = 0; y < 3; ++y)
  {
    for (int x = 0; x < 5; ++x)
    {
      function->SetScalarComponentFromDouble(x, y, 0, 0, x / 4.0);
      function->SetScalarComponentFromDouble(x, y, 0, 1, y / 2.0);
      function->SetScalarComponentFromDouble(x, y, 0, 2, 0.5);
      function->SetScalarComponentFromDouble(x, y, 0, 3, 0.1 * x / 4.0 * y / 2.0);
    }
  }
  return function;
}

// A block of 9 x 9 x 33 voxels, seen along z. The first value rises along x from 0 to 80, so that
// its gradient is 10, half of a quarter of the range. The second one is 30 in a range of 0 to 120.
class TwoValues
{
public:
  TwoValues()
    : scene(Values(), 9)
  {
    vtkVolumeProperty* property = this->scene.volume->GetProperty();
    property->SetTransferFunctionMode(vtkVolumeProperty::TF_2D);
    property->SetTransferFunction2D(Function());
    vtkCamera* camera = this->scene.renderer->GetActiveCamera();
    camera->ParallelProjectionOn();
    camera->SetParallelScale(0.4);
    camera->SetViewUp(0.0, 1.0, 0.0);
    camera->SetFocalPoint(4.0, 4.0, 0.0);
    camera->SetPosition(4.0, 4.0, 300.0);
    camera->SetClippingRange(1.0, 1000.0);
  }

  // Expects the image for values at these fractions of their ranges.
  void ExpectPlaces(double first, double second)
  {
    const double alpha = 1.0 - std::pow(1.0 - 0.1 * first * second, 32.0);
    const std::array<float, 4> drawn = this->scene.MiddlePixel();
    EXPECT_NEAR(drawn[3], alpha, HalfByteStep);
    EXPECT_NEAR(drawn[0], first * alpha, HalfByteStep);
    EXPECT_NEAR(drawn[1], second * alpha, HalfByteStep);
  }

  MapperScene scene;

private:
  static vtkSmartPointer<vtkImageData> Values()
  {
    const auto image = vtkSmartPointer<vtkImageData>::New();
    image->SetDimensions(9, 9, 33);
    image->AllocateScalars(VTK_SHORT, 1);
    vtkNew<vtkFloatArray> second;
    second->SetName("second");
    second->SetNumberOfTuples(9 * 9 * 33);
    for (int i = 0; i < 9 * 9 * 33; ++i)
    {
      static_cast<short*>(image->GetScalarPointer())[i] = short(10 * (i % 9));
      second->SetValue(i, i % 9 == 0 ? 120.0f * (i / 9 % 2) : 30.0f);
    }
    image->GetPointData()->AddArray(second);
    return image;
  }
};

}

TEST(FunctionsOfTwoValues, TakeTheGradientAndMeetTheEndsOfTheRange)
{
  TwoValues values;
  values.scene.mapper->AutoAdjustSampleDistancesOff();
  for (const double sampleDistance : { 4.0, 1.0, 0.25 })
  {
    values.scene.mapper->SetSampleDistance(sampleDistance);
    values.ExpectPlaces(0.5, 0.5);
  }
  // A value between the points of the function.
  vtkCamera* camera = values.scene.renderer->GetActiveCamera();
  camera->SetFocalPoint(5.3, 4.0, 0.0);
  camera->SetPosition(5.3, 4.0, 300.0);
  values.ExpectPlaces(5.3 / 8.0, 0.5);
}

TEST(FunctionsOfTwoValues, TakeAnArrayByName)
{
  TwoValues values;
  values.scene.mapper->SetTransfer2DYAxisArray("second");
  values.ExpectPlaces(0.5, 0.25);
  values.scene.mapper->SetTransfer2DYAxisArray("no such array");
  ExpectedVtkErrors errors;
  values.scene.window->Render();
  EXPECT_NE(errors.Text().find("no such array"), std::string::npos);
}

TEST(FunctionsOfTwoValues, OfAnArrayLeaveLabelsOutAndSaySo)
{
  TwoValues values;
  values.scene.mapper->SetTransfer2DYAxisArray("second");
  values.scene.mapper->SetMaskTypeToLabelMap();
  values.scene.mapper->SetMaskInput(MaskOf({ 9, 9, 33 }, [](glm::ivec3) { return 1; }));
  const ExpectedVtkErrors messages;
  values.scene.window->Render();
  EXPECT_NE(messages.Text().find("without a second array of values"), std::string::npos)
    << messages.Text();
}

TEST(FunctionsOfTwoValues, MayBeOfASinglePoint)
{
  TwoValues values;
  vtkNew<vtkImageData> point;
  point->SetDimensions(1, 1, 1);
  point->AllocateScalars(VTK_FLOAT, 4);
  const double colorAndOpacity[4] = { 1.0, 0.5, 0.0, 0.05 };
  for (int component = 0; component < 4; ++component)
  {
    point->SetScalarComponentFromDouble(0, 0, 0, component, colorAndOpacity[component]);
  }
  values.scene.volume->GetProperty()->SetTransferFunction2D(point);
  const double alpha = 1.0 - std::pow(1.0 - 0.05, 32.0);
  const std::array<float, 4> drawn = values.scene.MiddlePixel();
  EXPECT_NEAR(drawn[3], alpha, HalfByteStep);
  EXPECT_NEAR(drawn[0], alpha, HalfByteStep);
  EXPECT_NEAR(drawn[1], 0.5 * alpha, HalfByteStep);
}

TEST(FunctionsOfTwoValues, AreUploadedAnewWhenTheirImageChanges)
{
  TwoValues values;
  values.ExpectPlaces(0.5, 0.5);
  vtkImageData* function = values.scene.volume->GetProperty()->GetTransferFunction2D();
  function->GetPointData()->GetScalars()->FillComponent(3, 0.0);
  function->Modified();
  EXPECT_EQ(values.scene.MiddlePixel()[3], 0.0f);
}

class FunctionOfTorso : public testing::TestWithParam<bool>
{
};

TEST_P(FunctionOfTorso, IsThatOfTheReference)
{
  MapperScene scene(SmallTorso(), 48);
  vtkVolumeProperty* property = scene.volume->GetProperty();
  property->SetShade(GetParam());
  property->SetTransferFunctionMode(vtkVolumeProperty::TF_2D);
  property->SetTransferFunction2D(Function());

  const ImageError error = scene.ErrorOf(MaterialOfTwoValues(scene));
  EXPECT_LT(error.rootMeanSquare, 0.5);
  EXPECT_LT(error.largest, 10.0);
  const std::vector<float> drawn = scene.Draw();
  EXPECT_GT(*std::max_element(drawn.begin(), drawn.end()), 0.3) << "the image is empty";
}

INSTANTIATE_TEST_SUITE_P(ShadedOrNot, FunctionOfTorso, testing::Values(false, true));

TEST(FunctionsOfTwoValues, TakeTheirShadersOnlyWhereTheyAre)
{
  TwoValues values;
  values.scene.mapper->SetTransfer2DYAxisArray("second");
  values.scene.mapper->SetAccelerationModeToOff();
  values.scene.Draw();
  const std::vector<std::string> parts = values.scene.ShaderParts();
  const auto classify = std::find(parts.begin(), parts.end(), "ClassifyTwo/Table.glsl");
  const auto march = std::find(classify, parts.end(), "March/MaterialSegments.glsl");
  EXPECT_EQ(std::vector<std::string>(classify, march),
    (std::vector<std::string>{ "ClassifyTwo/Table.glsl", "Gradient/None.glsl", "Shade/None.glsl",
      "Values/Two.glsl", "Material/TwoValues.glsl", "Blend/Composite.glsl", "Sky/None.glsl" }));
}
