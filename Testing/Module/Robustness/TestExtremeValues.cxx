// Values at the ends of what doubles hold, and functions of them.

#include "Module/Scenes/MapperScene.h"
#include "Support/ExpectedVtkErrors.h"

#include <vtkDoubleArray.h>
#include <vtkPointData.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace varimarch;

namespace
{

/// Values that rise from one number to another, and functions of the same range.
class ExtremeRamp : public MapperScene
{
public:
  ExtremeRamp(double first, double last, vtkHeadlessRenderWindow* window)
    : MapperScene(Values(first, last), 16, window)
  {
    // Halves, because the difference of the ends may overflow.
    const double middle = 0.5 * first + 0.5 * last;
    this->colors->RemoveAllPoints();
    this->colors->AddRGBPoint(first, 0.9, 0.6, 0.3);
    this->opacities->RemoveAllPoints();
    this->opacities->AddPoint(first, 0.0);
    this->opacities->AddPoint(middle, 0.05);
    this->opacities->AddPoint(last, 0.3);
  }

private:
  static vtkSmartPointer<vtkImageData> Values(double first, double last)
  {
    constexpr int Side = 9;
    auto image = vtkSmartPointer<vtkImageData>::New();
    image->SetDimensions(Side, Side, Side);
    image->AllocateScalars(VTK_DOUBLE, 1);
    for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
    {
      const double part = double(i % Side) / (Side - 1);
      image->GetPointData()->GetScalars()->SetComponent(i, 0, (1.0 - part) * first + part * last);
    }
    return image;
  }
};

// The larger of the differences of two images.
double Difference(const std::vector<float>& one, const std::vector<float>& other)
{
  double largest = 0.0;
  for (std::size_t i = 0; i < one.size(); ++i)
  {
    const double difference = std::abs(double(one[i]) - double(other[i]));
    largest = std::isfinite(difference) ? std::max(largest, difference) : 1e9;
  }
  return largest;
}

}

TEST(ExtremeValues, AreDrawnLikeOrdinaryOnesOrNamed)
{
  vtkNew<vtkHeadlessRenderWindow> window;
  constexpr double Largest = std::numeric_limits<double>::max();
  for (const double first : { 0.0, -1.0 })
  {
    const std::vector<float> ordinary = ExtremeRamp(first, 1.0, window).Draw();
    for (const double scale : { 1e-320, 1e-300, 1e-290, 2e-290, 1e-280, 1e-250, 1e-40, 1e40, 1e250,
           1e300, 1e307, 1e308, Largest })
    {
      for (const bool byPackets : { true, false })
      {
        ExtremeRamp ramp(first * scale, scale, window);
        const ExpectedVtkErrors errors;
        const std::vector<float> drawn = byPackets ? ramp.DrawByProcessor() : ramp.Draw();
        const bool isNamed = errors.Text().find("Cannot draw scalars") != std::string::npos;
        EXPECT_TRUE(isNamed || Difference(drawn, ordinary) < 2.0 / 255.0)
          << first * scale << " to " << scale << ": " << Difference(drawn, ordinary);
        EXPECT_TRUE(!isNamed || scale < 1e-279 || scale > 1e299) << scale << ": " << errors.Text();
      }
    }
  }
}

TEST(ExtremeValues, OfAFillAreNoReasonToRefuseTheOthers)
{
  vtkNew<vtkHeadlessRenderWindow> window;
  const std::vector<float> ordinary = ExtremeRamp(0.0, 1.0, window).Draw();
  ExtremeRamp filled(0.0, 1.0, window);
  filled.image->GetPointData()->GetScalars()->SetComponent(
    0, 0, -std::numeric_limits<double>::max());
  filled.image->Modified();
  EXPECT_LT(Difference(filled.Draw(), ordinary), 0.1);
}

TEST(ExtremeValues, OfAFunctionThatAreNoNumbersAreNamed)
{
  constexpr double NotANumber = std::numeric_limits<double>::quiet_NaN();
  vtkNew<vtkHeadlessRenderWindow> window;
  for (const bool isValue : { true, false })
  {
    ExtremeRamp ramp(0.0, 1.0, window);
    ramp.opacities->AddPoint(isValue ? NotANumber : 0.4, isValue ? 0.5 : NotANumber);
    const ExpectedVtkErrors errors;
    const std::vector<float> drawn = ramp.Draw();
    EXPECT_NE(errors.Text().find("must be finite"), std::string::npos) << errors.Text();
    EXPECT_EQ(Difference(drawn, std::vector<float>(drawn.size())), 0.0);
  }
}

TEST(ExtremeValues, OfOpacitiesBeyondOneAreOpaqueAndBelowZeroClear)
{
  vtkNew<vtkHeadlessRenderWindow> window;
  ExtremeRamp within(0.0, 1.0, window);
  within.opacities->AddPoint(0.0, 0.0);
  within.opacities->AddPoint(0.5 * 3.0 / 3.05, 0.0); // where the curve beyond passes 0 and 1
  within.opacities->AddPoint(0.5 + 0.5 * 0.95 / 6.95, 1.0);
  within.opacities->AddPoint(1.0, 1.0);
  ExtremeRamp beyond(0.0, 1.0, window);
  beyond.opacities->AddPoint(0.0, -3.0);
  beyond.opacities->AddPoint(1.0, 7.0);
  EXPECT_LT(Difference(beyond.Draw(), within.Draw()), 1e-3);
}
