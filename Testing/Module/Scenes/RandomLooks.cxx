#include "Module/Scenes/RandomScenes.h"

#include <algorithm>
#include <sstream>

using varimarch::ValueRange;

namespace
{

struct Shape
{
  double midpoint = 0.5;
  double sharpness = 0.0;
};

// Nodes of opacity, and a description of them.
class RandomCurve
{
public:
  // An opaque value between voxels and a far value is an opaque film, thinner than any step.
  RandomCurve(const RandomVolume& volume, Dice& dice)
    : values(volume.values)
    , dice(dice)
    , hasFarValues(volume.hasFarValues)
    , most(dice.Chance(0.1) && !volume.hasFarValues ? 1.0 : dice.InOrdersBetween(0.02, 0.95))
  {
    this->curve->AllowDuplicateScalarsOn();
    this->text.precision(9);
  }

  vtkPiecewiseFunction* Make(bool smooth)
  {
    using Kind = void (RandomCurve::*)();
    std::vector<Kind> kinds = { &RandomCurve::Ramp, &RandomCurve::Nodes };
    if (!smooth)
    {
      kinds.insert(kinds.end(),
        { &RandomCurve::Nodes, &RandomCurve::Spike, &RandomCurve::OnePoint, &RandomCurve::Outside,
          &RandomCurve::Logarithmic });
    }
    // A step is as wide as one of 65536 entries over all values of whole numbers, far ones too.
    if (!smooth && !this->hasFarValues)
    {
      kinds.insert(kinds.end(), { &RandomCurve::Steps, &RandomCurve::Bent });
    }
    const Kind kind = this->dice.OneOf(kinds);
    (this->*kind)();
    if (!smooth && !this->hasFarValues && this->dice.Chance(0.06))
    {
      this->curve->ClampingOff();
      this->text << " unclamped";
    }
    return this->curve;
  }

  std::string Text() const { return this->text.str(); }

private:
  double At(double part) const { return this->values.lower + part * this->values.Width(); }
  double Opacity() { return this->dice.Chance(0.4) ? 0.0 : this->dice.Between(0.0, this->most); }

  void Add(double value, double opacity, const Shape& shape = {})
  {
    this->curve->AddPoint(value, opacity, shape.midpoint, shape.sharpness);
    this->text << " " << value << ":" << opacity;
    if (shape.sharpness > 0.0 || shape.midpoint != 0.5)
    {
      this->text << "(" << shape.midpoint << "," << shape.sharpness << ")";
    }
  }

  void Ramp()
  {
    const double from = this->dice.Between(-0.2, 0.7);
    const bool rises = this->dice.Chance(0.7);
    this->Add(this->At(from), rises ? 0.0 : this->most);
    this->Add(this->At(from + this->dice.Between(0.1, 1.0)), rises ? this->most : 0.0);
  }

  void Nodes()
  {
    const int count = this->dice.Whole(2, 6);
    for (int i = 0; i < count; ++i)
    {
      const double jitter = this->dice.Between(0.0, 0.8);
      this->Add(this->At(-0.1 + 1.2 * (i + jitter) / count), this->Opacity());
    }
  }

  void Steps()
  {
    const int count = this->dice.Whole(1, 3);
    double before = this->Opacity();
    for (int i = 0; i < count; ++i)
    {
      const double value = this->At((i + this->dice.Between(0.1, 0.9)) / count);
      const double behind = before > 0.0 ? 0.0 : this->dice.Between(0.2, 1.0) * this->most;
      this->Add(value, before);
      this->Add(value, behind);
      before = behind;
    }
  }

  void Spike()
  {
    const double place = this->dice.Between(0.05, 0.95);
    const double width = this->dice.InOrdersBetween(1e-4, 0.1);
    this->Add(this->At(place - width), 0.0);
    this->Add(this->At(place), this->most);
    this->Add(this->At(place + width), 0.0);
  }

  void OnePoint() { this->Add(this->At(this->dice.Between(-0.5, 1.5)), 0.3 * this->most); }

  void Outside()
  {
    const double beyond =
      this->dice.OneOf<double>({ -1.0, 1.0 }) * this->dice.InOrdersBetween(2.0, 50.0);
    this->Add(this->At(beyond), this->Opacity());
    this->Add(this->At(beyond + 1.5), 0.3 * this->most);
  }

  void Logarithmic()
  {
    const int orders = this->dice.Whole(1, 6);
    for (int i = orders; i >= 0; --i)
    {
      this->Add(this->At(std::pow(10.0, -i)), this->Opacity());
    }
  }

  void Bent()
  {
    const auto shape = [&]
    {
      return Shape{ this->dice.Between(0.05, 0.95),
        this->dice.OneOf<double>({ 0.0, 0.3, 0.7, 1.0 }) };
    };
    this->Add(this->At(this->dice.Between(0.0, 0.3)), 0.0, shape());
    this->Add(this->At(this->dice.Between(0.4, 0.6)), this->most, shape());
    this->Add(this->At(this->dice.Between(0.7, 1.0)), this->Opacity(), shape());
  }

  ValueRange values;
  Dice& dice;
  bool hasFarValues;
  double most;
  vtkNew<vtkPiecewiseFunction> curve;
  std::ostringstream text;
};

std::string SetRandomColors(
  vtkVolumeProperty* property, int component, const RandomVolume& volume, Dice& dice)
{
  const auto at = [&]
  { return volume.values.lower + dice.Between(-0.2, 1.2) * volume.values.Width(); };
  if (dice.Chance(0.15))
  {
    vtkNew<vtkPiecewiseFunction> gray;
    gray->AddPoint(at(), dice.Between(0.0, 1.0));
    gray->AddPoint(at(), dice.Between(0.0, 1.0));
    property->SetColor(component, gray);
    return "gray";
  }
  vtkNew<vtkColorTransferFunction> colors;
  const int count = dice.Whole(1, 4);
  for (int i = 0; i < count; ++i)
  {
    const double red = dice.Between(0.0, 1.0);
    const double green = dice.Between(0.0, 1.0);
    colors->AddRGBPoint(at(), red, green, dice.Between(0.0, 1.0));
  }
  const bool isHsv = dice.Chance(0.1);
  isHsv ? colors->SetColorSpaceToHSV() : colors->SetColorSpaceToRGB();
  property->SetColor(component, colors);
  return std::to_string(count) + (isHsv ? " colours by hue" : " colours");
}

}

std::string SetRandomLook(
  vtkVolumeProperty* property, int component, const RandomVolume& volume, bool smooth, Dice& dice)
{
  std::ostringstream text;
  RandomCurve curve(volume, dice);
  property->SetScalarOpacity(component, curve.Make(smooth));
  double spacing[3];
  volume.image->GetSpacing(spacing);
  const double mean = (spacing[0] + spacing[1] + spacing[2]) / 3.0;
  const double unit = mean * dice.InOrdersBetween(0.3, 5.0);
  property->SetScalarOpacityUnitDistance(component, unit);
  property->SetAmbient(component, dice.Between(0.0, 0.4));
  property->SetDiffuse(component, dice.Between(0.3, 0.8));
  property->SetSpecular(component, dice.Chance(0.5) ? 0.0 : dice.Between(0.0, 0.5));
  property->SetSpecularPower(component, dice.InOrdersBetween(1.0, 40.0));
  const std::string colors = SetRandomColors(property, component, volume, dice);
  text << "; opacity" << curve.Text() << " per " << unit << ", " << colors;
  return text.str();
}
