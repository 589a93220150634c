#include "Scene/Json/SceneNames.h"

#include "Scene/Measures/MeasureKinds.h"

#include <vtkType.h>

#include <algorithm>
#include <numeric>

namespace varimarch
{

namespace
{

// Number of letters to insert, delete or replace (Levenshtein distance).
std::size_t EditDistance(const std::string& a, const std::string& b)
{
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), 0);
  for (std::size_t i = 1; i <= a.size(); ++i)
  {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j)
    {
      const std::size_t replaced = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({ replaced, row[j] + 1, row[j - 1] + 1 });
    }
  }
  return row.back();
}

}

const NameTable<View>& ViewNames()
{
  static const NameTable<View> table = { { "automatic", View::Automatic },
    { "anterior", View::Anterior }, { "posterior", View::Posterior }, { "left", View::Left },
    { "right", View::Right }, { "superior", View::Superior }, { "inferior", View::Inferior } };
  return table;
}

const NameTable<Blend>& BlendNames()
{
  static const NameTable<Blend> table = { { "composite", Blend::Composite },
    { "maximum", Blend::MaximumIntensity }, { "minimum", Blend::MinimumIntensity },
    { "average", Blend::AverageIntensity }, { "additive", Blend::Additive },
    { "isosurface", Blend::Isosurface } };
  return table;
}

const NameTable<Acceleration>& AccelerationNames()
{
  static const NameTable<Acceleration> table = { { "off", Acceleration::Off },
    { "cells", Acceleration::CellField }, { "variation", Acceleration::VariationField },
    { "optical", Acceleration::OpticalField } };
  return table;
}

const NameTable<Integration>& IntegrationNames()
{
  static const NameTable<Integration> table = { { "midpoint", Integration::Midpoint },
    { "pre-integrated", Integration::PreIntegrated }, { "simpson", Integration::Simpson },
    { "published-sum", Integration::PublishedSum }, { "first-hit", Integration::FirstHit } };
  return table;
}

const NameTable<VoxelDistance>& VoxelDistanceNames()
{
  static const NameTable<VoxelDistance> table = { { "euclidean", VoxelDistance::Euclidean },
    { "chebyshev", VoxelDistance::Chebyshev } };
  return table;
}

const NameTable<Lengths>& LengthsNames()
{
  static const NameTable<Lengths> table = { { "millimetres", Lengths::Millimetres },
    { "relative", Lengths::Relative } };
  return table;
}

const NameTable<Domain>& DomainNames()
{
  static const NameTable<Domain> table = { { "data", Domain::Data },
    { "relative", Domain::Relative }, { "hounsfield", Domain::Hounsfield } };
  return table;
}

const NameTable<VolumeLevel>& LevelNames()
{
  static const NameTable<VolumeLevel> table = { { "voxels", VolumeLevel::Voxels },
    { "coarse", VolumeLevel::Coarse }, { "automatic", VolumeLevel::Automatic },
    { "refined", VolumeLevel::Refined } };
  return table;
}

const NameTable<Interpolation>& InterpolationNames()
{
  static const NameTable<Interpolation> table = { { "nearest", Interpolation::Nearest },
    { "linear", Interpolation::Linear }, { "cubic", Interpolation::Cubic } };
  return table;
}

const NameTable<LightKind>& LightKindNames()
{
  static const NameTable<LightKind> table = { { "head", LightKind::Head },
    { "camera", LightKind::Camera }, { "directional", LightKind::Directional },
    { "positional", LightKind::Positional } };
  return table;
}

const NameTable<RegionShape>& RegionShapeNames()
{
  static const NameTable<RegionShape> table = { { "rectangle", RegionShape::Rectangle },
    { "ellipse", RegionShape::Ellipse } };
  return table;
}

const NameTable<ProceduralKind>& ProceduralNames()
{
  static const NameTable<ProceduralKind> table = { { "shells", ProceduralKind::Shells },
    { "marschner-lobb", ProceduralKind::MarschnerLobb }, { "torso", ProceduralKind::Torso },
    { "checkerboard", ProceduralKind::Checkerboard }, { "ramp", ProceduralKind::Ramp } };
  return table;
}

const NameTable<SlabBlend>& SlabBlendNames()
{
  static const NameTable<SlabBlend> table = { { "maximum", SlabBlend::Maximum },
    { "minimum", SlabBlend::Minimum }, { "mean", SlabBlend::Mean } };
  return table;
}

const NameTable<SliceFusion>& SliceFusionNames()
{
  static const NameTable<SliceFusion> names = { { "blend", SliceFusion::Blend },
    { "checkerboard", SliceFusion::Checkerboard } };
  return names;
}

const NameTable<MeasureKind>& MeasureKindNames()
{
  static const NameTable<MeasureKind> names = []
  {
    NameTable<MeasureKind> table;
    for (const MeasureTraits& traits : AllMeasureTraits())
    {
      table.emplace_back(traits.name, traits.kind);
    }
    return table;
  }();
  return names;
}

const NameTable<KeyView>& KeyViewNames()
{
  static const NameTable<KeyView> names = { { "volume", KeyView::Volume },
    { "axial", KeyView::Axial }, { "coronal", KeyView::Coronal },
    { "sagittal", KeyView::Sagittal } };
  return names;
}

const NameTable<SliceColors>& SliceColorsNames()
{
  static const NameTable<SliceColors> names = { { "gray", SliceColors::Gray },
    { "hot", SliceColors::Hot }, { "green", SliceColors::Green } };
  return names;
}

const NameTable<bool>& ProjectionNames()
{
  static const NameTable<bool> table = { { "perspective", false }, { "parallel", true } };
  return table;
}

const NameTable<bool>& ByteOrderNames()
{
  static const NameTable<bool> table = { { "little", false }, { "big", true } };
  return table;
}

const NameTable<MapperKind>& MapperKindNames()
{
  static const NameTable<MapperKind> table = { { "ours", MapperKind::Varimarch },
    { "ours-shader", MapperKind::VarimarchShaders }, { "vtk-gpu", MapperKind::VtkGpu },
    { "vtk-cpu", MapperKind::VtkCpu } };
  return table;
}

const NameTable<int>& RawTypeNames()
{
  static const NameTable<int> table = { { "uint8", VTK_UNSIGNED_CHAR }, { "int8", VTK_SIGNED_CHAR },
    { "uint16", VTK_UNSIGNED_SHORT }, { "int16", VTK_SHORT }, { "uint32", VTK_UNSIGNED_INT },
    { "int32", VTK_INT }, { "uint64", VTK_TYPE_UINT64 }, { "int64", VTK_TYPE_INT64 },
    { "float32", VTK_FLOAT }, { "float64", VTK_DOUBLE } };
  return table;
}

std::string Suggestion(const std::string& name, const std::vector<std::string>& known)
{
  const auto nearest = std::min_element(known.begin(), known.end(),
    [&](const std::string& a, const std::string& b)
    { return EditDistance(name, a) < EditDistance(name, b); });
  // If more than a third of the letters differ, it is not a typing error.
  if (nearest != known.end() && 3 * EditDistance(name, *nearest) <= nearest->size() + 2)
  {
    return "did you mean \"" + *nearest + "\"?";
  }
  std::string list;
  for (const std::string& candidate : known)
  {
    list += (list.empty() ? "known: " : ", ") + candidate;
  }
  return list;
}

}
