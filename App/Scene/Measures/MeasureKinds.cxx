#include "Scene/Measures/MeasureKinds.h"

#include "Scene/Model/WorldVector.h"
#include "Scene/Slices/CurvedPicture.h"
#include "Scene/Volumes/VolumeLoading.h"

#include <vtkImageData.h>

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <locale>
#include <sstream>

namespace varimarch
{

namespace
{

glm::dvec3 PointOf(const Measure& measure, int i)
{
  return VectorOf(measure.pointsMm[i]);
}

// Angle [degrees], from 0 to 180; 0 if a direction has no length. The arctangent stays exact for
// nearly parallel directions, unlike the arc cosine.
double DegreesBetween(const glm::dvec3& first, const glm::dvec3& second)
{
  return glm::degrees(std::atan2(glm::length(glm::cross(first, second)), glm::dot(first, second)));
}

MeasureLines LineThroughPoints(const Measure& measure, vtkImageData*)
{
  return { PointsOf(measure) };
}

MeasureValues LengthOfLine(const Measure& measure, vtkImageData*, vtkImageData*)
{
  return { glm::distance(PointOf(measure, 0), PointOf(measure, 1)) };
}

MeasureLines ArmsFromVertex(const Measure& measure, vtkImageData*)
{
  return { { PointOf(measure, 1), PointOf(measure, 0) },
    { PointOf(measure, 1), PointOf(measure, 2) } };
}

MeasureValues AngleAtVertex(const Measure& measure, vtkImageData*, vtkImageData*)
{
  const glm::dvec3 vertex = PointOf(measure, 1);
  return { {}, DegreesBetween(PointOf(measure, 0) - vertex, PointOf(measure, 2) - vertex) };
}

MeasureLines TwoLines(const Measure& measure, vtkImageData*)
{
  return { { PointOf(measure, 0), PointOf(measure, 1) },
    { PointOf(measure, 2), PointOf(measure, 3) } };
}

// Lines have no direction, so that the angle is at most 90 degrees.
MeasureValues AngleOfLines(const Measure& measure, vtkImageData*, vtkImageData*)
{
  const double degrees = DegreesBetween(
    PointOf(measure, 1) - PointOf(measure, 0), PointOf(measure, 3) - PointOf(measure, 2));
  return { {}, std::min(degrees, 180.0 - degrees) };
}

// The edges of a box along the volume's axes.
MeasureLines EdgesOfBox(const Measure& measure, vtkImageData* image)
{
  glm::dvec3 first;
  glm::dvec3 last;
  image->TransformPhysicalPointToContinuousIndex(measure.pointsMm[0].data(), &first.x);
  image->TransformPhysicalPointToContinuousIndex(measure.pointsMm[1].data(), &last.x);
  const auto corner = [&](int i)
  {
    const glm::dvec3 index(
      i & 1 ? last.x : first.x, i >> 1 & 1 ? last.y : first.y, i >> 2 ? last.z : first.z);
    glm::dvec3 point;
    image->TransformContinuousIndexToPhysicalPoint(&index.x, &point.x);
    return point;
  };
  MeasureLines edges;
  for (int i = 0; i < 8; ++i)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      if (!(i >> axis & 1))
      {
        edges.push_back({ corner(i), corner(i | 1 << axis) });
      }
    }
  }
  return edges;
}

MeasureValues ValuesOfBox(const Measure& measure, vtkImageData* image, vtkImageData* voxels)
{
  const RegionStatistics found =
    StatisticsOfBox(measure.pointsMm[0], measure.pointsMm[1], image, voxels);
  return { {}, {}, {}, found.volumeMm3, found };
}

// Points on an ellipse, as many as no screen shows corners of.
std::vector<glm::dvec3> PointsOnEllipse(const Measure& measure)
{
  constexpr int Count = 180;
  const glm::dvec3 middle = PointOf(measure, 0);
  std::vector<glm::dvec3> points;
  for (int i = 0; i < Count; ++i)
  {
    const double angle = glm::two_pi<double>() * i / Count;
    points.push_back(middle + std::cos(angle) * (PointOf(measure, 1) - middle) +
      std::sin(angle) * (PointOf(measure, 2) - middle));
  }
  return points;
}

MeasureLines Closed(std::vector<glm::dvec3> points)
{
  points.push_back(points.front());
  return { std::move(points) };
}

MeasureLines LineOfEllipse(const Measure& measure, vtkImageData*)
{
  return Closed(PointsOnEllipse(measure));
}

MeasureValues ValuesOfEllipse(const Measure& measure, vtkImageData*, vtkImageData* voxels)
{
  const glm::dvec3 middle = PointOf(measure, 0);
  const double areaMm2 = glm::pi<double>() *
    glm::length(glm::cross(PointOf(measure, 1) - middle, PointOf(measure, 2) - middle));
  return { {}, {}, areaMm2, {}, StatisticsOfFlatRegion(PointsOnEllipse(measure), voxels) };
}

MeasureLines LineOfOutline(const Measure& measure, vtkImageData*)
{
  return Closed(PointsOf(measure));
}

MeasureValues ValuesOfOutline(const Measure& measure, vtkImageData*, vtkImageData* voxels)
{
  const std::vector<glm::dvec3> outline = PointsOf(measure);
  return { {}, {}, glm::length(AreaVector(outline)), {}, StatisticsOfFlatRegion(outline, voxels) };
}

MeasureLines LineOfCurve(const Measure& measure, vtkImageData*)
{
  return { CurvePath(measure.pointsMm).Points() };
}

MeasureValues LengthOfCurve(const Measure& measure, vtkImageData*, vtkImageData*)
{
  return { CurvePath(measure.pointsMm).LengthMm() };
}

}

const std::vector<MeasureTraits>& AllMeasureTraits()
{
  constexpr int Middle = -1;
  using Handles = MeasureHandles;
  using Sign = MeasureSign;
  static const std::vector<MeasureTraits> all = {
    { MeasureKind::Distance, "distance", 2, 2, Handles::Each, Sign::None, false, false, Middle,
      &LineThroughPoints, &LengthOfLine },
    { MeasureKind::Angle, "angle", 3, 3, Handles::Each, Sign::Arc, false, false, 1, &ArmsFromVertex,
      &AngleAtVertex },
    { MeasureKind::CobbAngle, "cobb", 4, 4, Handles::Each, Sign::None, false, false, Middle,
      &TwoLines, &AngleOfLines },
    { MeasureKind::Box, "box", 2, 2, Handles::Each, Sign::None, false, false, 1, &EdgesOfBox,
      &ValuesOfBox },
    { MeasureKind::Ellipse, "ellipse", 3, 3, Handles::FirstMovesAll, Sign::None, true, false, 1,
      &LineOfEllipse, &ValuesOfEllipse },
    { MeasureKind::Freehand, "freehand", 3, MostMeasurePoints, Handles::FirstOnly, Sign::None, true,
      false, 0, &LineOfOutline, &ValuesOfOutline },
    { MeasureKind::Curve, "curve", 1, MostMeasurePoints, Handles::Each, Sign::None, false, false, 0,
      &LineOfCurve, &LengthOfCurve },
    { MeasureKind::Arrow, "arrow", 2, 2, Handles::Each, Sign::ArrowHead, false, true, 0,
      &LineThroughPoints, nullptr },
    { MeasureKind::Text, "text", 1, 1, Handles::Each, Sign::None, false, true, 0, nullptr,
      nullptr },
  };
  return all;
}

const MeasureTraits& TraitsOf(MeasureKind kind)
{
  return AllMeasureTraits()[std::size_t(kind)];
}

MeasureLines LinesOf(const Measure& measure, vtkImageData* image)
{
  const auto linesOf = TraitsOf(measure.kind).linesOf;
  return linesOf ? linesOf(measure, image) : MeasureLines();
}

MeasureValues ValuesOf(const Measure& measure, vtkImageData* image)
{
  const auto valuesOf = TraitsOf(measure.kind).valuesOf;
  return valuesOf ? valuesOf(measure, image, image) : MeasureValues();
}

std::optional<RegionStatistics> StatisticsOver(
  const Measure& measure, vtkImageData* image, vtkImageData* over)
{
  // Lengths and angles take no voxels.
  const auto valuesOf = TraitsOf(measure.kind).valuesOf;
  return valuesOf ? valuesOf(measure, image, over).statistics : std::nullopt;
}

std::vector<glm::dvec3> PointsOf(const Measure& measure)
{
  std::vector<glm::dvec3> points;
  std::transform(
    measure.pointsMm.begin(), measure.pointsMm.end(), std::back_inserter(points), VectorOf);
  return points;
}

glm::dvec3 MiddleOf(const Measure& measure)
{
  glm::dvec3 sum(0.0);
  for (const glm::dvec3& point : PointsOf(measure))
  {
    sum += point;
  }
  return sum / double(measure.pointsMm.size());
}

std::size_t HandleCount(const Measure& measure)
{
  return TraitsOf(measure.kind).handles == MeasureHandles::FirstOnly ? 1 : measure.pointsMm.size();
}

void MovePoint(Measure& measure, int point, const glm::dvec3& stepMm)
{
  const bool movesAll = point == 0 && TraitsOf(measure.kind).handles != MeasureHandles::Each;
  for (int i = 0; i < int(measure.pointsMm.size()); ++i)
  {
    if (movesAll || i == point)
    {
      measure.pointsMm[i] = NumbersOf(VectorOf(measure.pointsMm[i]) + stepMm);
    }
  }
}

std::string UnitOf(const LoadedVolume& volume)
{
  return volume.modality == "CT" ? "HU" : volume.uptakeValueFactor > 0.0 ? "SUV" : "";
}

double FactorToUnit(const LoadedVolume& volume)
{
  return volume.uptakeValueFactor > 0.0 ? volume.uptakeValueFactor : 1.0;
}

RegionStatistics InUnits(RegionStatistics statistics, const LoadedVolume& volume)
{
  const double factor = FactorToUnit(volume);
  statistics.mean *= factor;
  statistics.standardDeviation *= factor;
  statistics.smallest *= factor;
  statistics.largest *= factor;
  return statistics;
}

MeasureValues InUnits(MeasureValues values, const LoadedVolume& volume)
{
  if (values.statistics)
  {
    values.statistics = InUnits(*values.statistics, volume);
  }
  return values;
}

namespace
{

void WriteNumber(std::ostream& line, const std::optional<double>& number)
{
  line << ',';
  if (number)
  {
    line << *number;
  }
}

void WriteStatistics(
  std::ostream& line, const std::optional<RegionStatistics>& statistics, const std::string& unit)
{
  if (!statistics || statistics->voxels == 0)
  {
    line << ',' << (statistics ? "0" : "") << ",,,,,";
    return;
  }
  line << ',' << statistics->voxels << ',' << statistics->mean << ','
       << statistics->standardDeviation << ',' << statistics->smallest << ',' << statistics->largest
       << ',' << unit;
}

void WritePoints(std::ostream& line, const Measure& measure, int volume)
{
  line << ",\"";
  const char* separator = "";
  for (const auto& [x, y, z] : measure.pointsMm)
  {
    line << separator << x << ' ' << y << ' ' << z;
    separator = "; ";
  }
  line << "\"," << volume << '\n';
}

void WriteLine(std::ostream& text, int number, const Measure& measure, const MeasureValues& values,
  const PlacedVolume& of)
{
  text << number << ',' << TraitsOf(measure.kind).name << ',' << QuotedForCsv(measure.name);
  WriteNumber(text, values.lengthMm);
  WriteNumber(text, values.degrees);
  WriteNumber(text, values.areaMm2);
  WriteNumber(text, values.volumeMm3);
  WriteStatistics(text, values.statistics, UnitOf(of.volume));
  WritePoints(text, measure, of.number);
}

}

std::string CsvOf(const std::vector<Measure>& measures, const LoadedVolume& volume,
  const std::vector<PlacedVolume>& over)
{
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text.precision(std::numeric_limits<float>::max_digits10);
  text << "number,kind,name,length_mm,angle_degrees,area_mm2,volume_mm3,voxels,mean,"
          "standard_deviation,smallest,largest,unit,points_mm,volume\n";
  int number = 0;
  for (const Measure& measure : measures)
  {
    const MeasureValues values = ValuesOf(measure, volume.image);
    WriteLine(text, ++number, measure, InUnits(values, volume), { 1, volume, volume.image });
    for (const PlacedVolume& other : over)
    {
      if (const auto statistics = StatisticsOver(measure, volume.image, other.image))
      {
        MeasureValues ofOther = { {}, {}, values.areaMm2, {}, InUnits(*statistics, other.volume) };
        if (values.volumeMm3)
        {
          ofOther.volumeMm3 = statistics->volumeMm3;
        }
        WriteLine(text, number, measure, ofOther, other);
      }
    }
  }
  return text.str();
}

}
