// The flags of VTK's functions, judged by what VTK's own GetValue() and GetColor() return.

#include "Frame/PropertyTransferFunction.h"
#include "Module/Scenes/Dice.h"
#include "Module/Scenes/HomogeneousScene.h"
#include "Support/ExpectedVtkErrors.h"

#include <vtkDataArray.h>
#include <vtkDiscretizableColorTransferFunction.h>
#include <vtkPointData.h>
#include <vtkVariant.h>
#include <vtkVariationFieldGPUVolumeRayCastMapper.h>

#include <glm/common.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

using namespace varimarch;

namespace
{

// Straight pieces follow a curve to 1/20000, but for kinks between the places at which they are
// compared with it.
constexpr double Near = 2e-4;

// The number of values at which functions are compared.
constexpr int Places = 300;

class RandomFunctions
{
public:
  explicit RandomFunctions(int subject)
    : dice(52, subject)
  {
  }

  double Number(double lower, double upper) { return this->dice.Between(lower, upper); }
  bool Yes(double probability) { return this->dice.Chance(probability); }
  int Choice(int count) { return this->dice.Whole(0, count - 1); }

  // Ascending values, some of which repeat.
  std::vector<double> Values(bool arePositive)
  {
    std::vector<double> values;
    for (int i = this->Choice(6); i >= 0; --i)
    {
      values.push_back(arePositive ? std::pow(10.0, this->Number(-2.0, 4.0))
                                   : std::round(this->Number(-300.0, 1000.0)));
    }
    std::sort(values.begin(), values.end());
    return values;
  }

  double Shape() { return this->Yes(0.6) ? 0.5 : this->Number(0.0, 1.0); }
  double Sharpness()
  {
    return this->Yes(0.6) ? 0.0 : this->Yes(0.2) ? 1.0 : this->Number(0.0, 1.0);
  }

  void Fill(vtkPiecewiseFunction* function)
  {
    const bool isLogarithmic = this->Yes(0.5);
    const bool exceedsOne = this->Yes(0.2);
    function->SetUseLogScale(isLogarithmic);
    function->SetClamping(this->Yes(0.7));
    function->SetAllowDuplicateScalars(this->Yes(0.5));
    for (const double value : this->Values(isLogarithmic))
    {
      const double ordinate = exceedsOne ? this->Number(-0.5, 1.5) : this->Number(0.0, 1.0);
      function->AddPoint(value, ordinate, this->Shape(), this->Sharpness());
    }
  }

  void Fill(vtkColorTransferFunction* function)
  {
    const bool isLogarithmic = this->Yes(0.3);
    const bool exceedsOne = this->Yes(0.1);
    function->SetScale(isLogarithmic ? VTK_CTF_LOG10 : VTK_CTF_LINEAR);
    const int spaces[] = { VTK_CTF_RGB, VTK_CTF_HSV, VTK_CTF_LAB, VTK_CTF_DIVERGING, VTK_CTF_STEP };
    function->SetColorSpace(spaces[this->Choice(5)]);
    function->SetHSVWrap(this->Yes(0.5));
    function->SetClamping(this->Yes(0.7));
    function->SetUseBelowRangeColor(this->Yes(0.4));
    function->SetUseAboveRangeColor(this->Yes(0.4));
    function->SetBelowRangeColor(this->Number(0.0, 1.0), this->Number(0.0, 1.0), 0.5);
    function->SetAboveRangeColor(this->Number(0.0, 1.0), 0.5, this->Number(0.0, 1.0));
    function->SetAllowDuplicateScalars(this->Yes(0.5));
    const double most = exceedsOne ? 1.4 : 1.0;
    for (const double value : this->Values(isLogarithmic && this->Yes(0.8)))
    {
      function->AddRGBPoint(value, this->Number(1.0 - most, most), this->Number(0.0, 1.0),
        this->Number(0.0, most), this->Shape(), this->Sharpness());
    }
  }

  // A value within, or beyond, the range of a function; on its scale.
  double Place(const double* range, bool isLogarithmic)
  {
    const double beyond = this->Number(-0.2, 1.2);
    return isLogarithmic && range[0] > 0.0
      ? range[0] * std::pow(std::max(range[1] / range[0], 2.0), beyond)
      : range[0] + std::max(range[1] - range[0], 1.0) * beyond;
  }

private:
  Dice dice;
};

// True if a function is continuous at a value, about. Beside a jump, a value is on either side.
template <class Function>
bool IsSteep(const Function& function, double value)
{
  const double apart = 1e-9 * std::max(std::abs(value), 1e-6);
  const glm::dvec3 change = glm::abs(function(value + apart) - function(value - apart));
  return std::max({ change.r, change.g, change.b }) > Near;
}

glm::dvec3 ColorOf(vtkColorTransferFunction* function, double value)
{
  glm::dvec3 rgb;
  function->GetColor(value, &rgb.r);
  return glm::clamp(rgb, 0.0, 1.0);
}

void ExpectColorsOfVtk(
  RandomFunctions& random, vtkColorTransferFunction* function, const std::string& name)
{
  vtkNew<vtkVolumeProperty> property;
  property->SetColor(function);
  const TransferFunction ours = TransferFunctionOf(property);
  const auto vtk = [&](double value) { return ColorOf(function, value); };
  for (int place = 0; place < Places; ++place)
  {
    const double value = random.Place(function->GetRange(), function->GetScale() == VTK_CTF_LOG10);
    if (!IsSteep(vtk, value))
    {
      const glm::dvec3 apart = glm::abs(ours.Color(value) - vtk(value));
      ASSERT_LT(std::max({ apart.r, apart.g, apart.b }), Near)
        << name << " at " << value << ", colour space " << function->GetColorSpace();
    }
  }
}

// A cube of one value through which the middle ray goes along its edge of 16 mm.
struct OneValueScene : HomogeneousScene
{
  explicit OneValueScene(double value)
  {
    this->image->GetPointData()->GetScalars()->Fill(value);
    // Not all voxels are the same, or the look would be computed once for all.
    this->image->GetPointData()->GetScalars()->SetComponent(0, 0, value + 100.0);
    this->image->GetPointData()->GetScalars()->SetComponent(1, 0, value - 100.0);
    this->image->Modified();
    this->colors->RemoveAllPoints();
    this->opacities->RemoveAllPoints();
    this->volume->GetProperty()->SetColor(this->colors);
    this->volume->GetProperty()->SetScalarOpacity(this->opacities);
    this->volume->GetProperty()->SetScalarOpacityUnitDistance(SideMm);
  }

  void ExpectThatOfVtk(double value, const std::string& name)
  {
    const std::array<float, 4> pixel = this->MiddlePixel();
    const double opacity = this->opacities->GetValue(value);
    const glm::dvec3 rgb = ColorOf(this->colors, value);
    for (int channel = 0; channel < 3; ++channel)
    {
      EXPECT_NEAR(pixel[channel], opacity * rgb[channel], 2e-3) << name << ", " << channel;
    }
    EXPECT_NEAR(pixel[3], opacity, 2e-3) << name;
  }
};

}

TEST(FunctionFlags, OpacityCurvesAreThoseOfVtkWhateverTheirFlags)
{
  RandomFunctions random(1);
  for (int function = 0; function < 400; ++function)
  {
    vtkNew<vtkPiecewiseFunction> curve;
    random.Fill(curve);
    vtkNew<vtkVolumeProperty> property;
    property->SetScalarOpacity(curve);
    property->SetColor(curve.Get());
    const TransferFunction ours = TransferFunctionOf(property);
    const auto vtk = [&](double value)
    { return glm::dvec3(std::clamp(curve->GetValue(value), 0.0, 1.0)); };
    for (int place = 0; place < Places; ++place)
    {
      const double value = random.Place(curve->GetRange(), curve->GetUseLogScale());
      if (!IsSteep(vtk, value))
      {
        ASSERT_NEAR(ours.Opacity(value), vtk(value).r, Near) << function << " at " << value;
        ASSERT_NEAR(ours.Color(value).g, vtk(value).g, Near) << function << " at " << value;
      }
    }
  }
}

TEST(FunctionFlags, ColoursAreThoseOfVtkWhateverTheirFlags)
{
  RandomFunctions random(2);
  for (int function = 0; function < 400; ++function)
  {
    vtkNew<vtkColorTransferFunction> colors;
    random.Fill(colors);
    ExpectColorsOfVtk(random, colors, "function " + std::to_string(function));
  }
}

TEST(FunctionFlags, ATableOfColoursIsThatOfVtk)
{
  RandomFunctions random(3);
  for (int function = 0; function < 60; ++function)
  {
    vtkNew<vtkDiscretizableColorTransferFunction> colors;
    random.Fill(colors);
    colors->SetUseLogScale(colors->GetScale() == VTK_CTF_LOG10);
    colors->SetDiscretize(random.Yes(0.8));
    colors->SetNumberOfValues(1 + random.Choice(random.Yes(0.5) ? 12 : 300));
    colors->Build();
    if (colors->GetRange()[0] == colors->GetRange()[1])
    {
      continue; // VTK's table of a single value is not defined
    }
    ExpectColorsOfVtk(random, colors, "table " + std::to_string(function));
  }
}

TEST(FunctionFlags, ColoursOnPathsInCiede2000AreThoseOfVtk)
{
  RandomFunctions random(4);
  vtkNew<vtkColorTransferFunction> colors;
  colors->SetColorSpaceToLabCIEDE2000();
  colors->AddRGBPoint(10.0, 0.1, 0.2, 0.9, 0.4, 0.3);
  colors->AddRGBPoint(200.0, 0.9, 0.8, 0.1);
  vtkNew<vtkVolumeProperty> property;
  property->SetColor(colors);
  const TransferFunction ours = TransferFunctionOf(property);
  for (int place = 0; place < 8; ++place)
  {
    const double value = random.Number(10.0, 200.0);
    const glm::dvec3 apart = glm::abs(ours.Color(value) - ColorOf(colors, value));
    EXPECT_LT(std::max({ apart.r, apart.g, apart.b }), 5e-3) << "VTK rounds them to 8 bits";
  }
}

TEST(FunctionFlags, ValuesAtTheirNodesHaveTheColoursOfVtk)
{
  vtkNew<vtkColorTransferFunction> colors;
  colors->SetColorSpaceToStep();
  colors->UseBelowRangeColorOn();
  colors->SetBelowRangeColor(0.0, 1.0, 0.0);
  colors->UseAboveRangeColorOn();
  colors->SetAboveRangeColor(1.0, 0.0, 1.0);
  vtkNew<vtkVolumeProperty> property;
  property->SetColor(colors);
  for (int value = 0; value < 5; ++value)
  {
    colors->AddRGBPoint(value, 0.2 * value, 0.0, 1.0 - 0.2 * value);
  }
  const TransferFunction ours = TransferFunctionOf(property);
  for (int value = -1; value < 6; ++value)
  {
    EXPECT_EQ(ours.Color(value), ColorOf(colors, value)) << value;
  }
  for (const bool isClamped : { true, false })
  {
    colors->SetClamping(isClamped);
    for (double value : { 0.0, 1.0, 4.0, -0.01, 4.01 })
    {
      OneValueScene scene(value);
      scene.colors->DeepCopy(colors);
      scene.opacities->AddPoint(0.0, 0.6);
      scene.ExpectThatOfVtk(value, "value " + std::to_string(value));
    }
  }
}

TEST(FunctionFlags, AreSeenInPictures)
{
  {
    OneValueScene scene(200.0);
    scene.opacities->AddPoint(1.0, 0.0);
    scene.opacities->AddPoint(1000.0, 0.5);
    scene.opacities->UseLogScaleOn();
    scene.colors->AddRGBPoint(1.0, 0.1, 0.2, 0.9);
    scene.colors->AddRGBPoint(1000.0, 1.0, 0.8, 0.1);
    scene.colors->SetScaleToLog10();
    scene.ExpectThatOfVtk(200.0, "logarithmic scales");
  }
  for (const double value : { -5.0, 5.0, 25.0 })
  {
    OneValueScene scene(value);
    scene.opacities->AddPoint(0.0, 0.3);
    scene.colors->AddRGBPoint(0.0, 0.0, 0.0, 1.0);
    scene.colors->AddRGBPoint(10.0, 1.0, 0.0, 0.0);
    scene.colors->UseBelowRangeColorOn();
    scene.colors->SetBelowRangeColor(0.0, 1.0, 0.0);
    scene.colors->UseAboveRangeColorOn();
    scene.colors->SetAboveRangeColor(1.0, 1.0, 0.0);
    scene.ExpectThatOfVtk(value, "colours beyond the range");
  }
}

TEST(FunctionFlags, ATableOfColoursIsMadeBeforeTheFirstImageLooksAtItsTime)
{
  MapperScene scene(SmallTorso(), 16);
  vtkNew<vtkDiscretizableColorTransferFunction> colors;
  colors->AddRGBPoint(-1000.0, 0.1, 0.2, 0.3);
  colors->AddRGBPoint(1000.0, 0.9, 0.8, 0.3);
  colors->DiscretizeOn();
  scene.volume->GetProperty()->SetColor(colors);
  scene.Draw();
  const int builds = scene.mapper->GetOpticalTableBuilds();
  scene.Draw();
  EXPECT_EQ(scene.mapper->GetOpticalTableBuilds(), builds);
}

TEST(FunctionFlags, ThatAreNotSupportedAreNamed)
{
  MapperScene scene(SmallTorso(), 16);
  vtkNew<vtkVariationFieldGPUVolumeRayCastMapper> adapter;
  adapter->SetInputData(scene.image);
  const auto reason = [&]
  {
    adapter->ChooseMapper(scene.renderer, scene.volume);
    return std::string(adapter->GetReasonForVtkMapper());
  };
  EXPECT_EQ(reason(), "");
  scene.colors->SetIndexedLookup(1);
  EXPECT_NE(reason().find("IndexedLookup"), std::string::npos) << reason();
  {
    const ExpectedVtkErrors errors;
    scene.Draw();
    EXPECT_NE(errors.Text().find("IndexedLookup"), std::string::npos) << errors.Text();
  }
  scene.colors->SetIndexedLookup(0);
  EXPECT_EQ(reason(), "");
  vtkNew<vtkPiecewiseFunction> factors;
  factors->AddPoint(0.0, 1.0);
  factors->AddPoint(10.0, 0.5);
  factors->UseLogScaleOn();
  scene.volume->GetProperty()->SetGradientOpacity(factors);
  EXPECT_NE(reason().find("needs nodes above 0, found 0"), std::string::npos) << reason();
  factors->RemovePoint(0.0);
  EXPECT_EQ(reason(), "");
}
