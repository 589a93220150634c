#ifndef Varimarch_March_MapperInternals_h
#define Varimarch_March_MapperInternals_h

#include "Core/Quality/InteractiveQuality.h"
#include "Levels/LevelOfDetail.h"
#include "March/RayMarcher.h"
#include "vtkVariationFieldVolumeMapper.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

/// The parts of a mapper that its public header does not show.
struct vtkVariationFieldVolumeMapper::Internals
{
  // Records that another mapper has already drawn this one's volume: the first of several volumes
  // to be rendered draws them all, back to front.
  struct DrawnAhead
  {
    vtkRenderer* Renderer = nullptr;
    vtkMTimeType Time = 0; // modification time of the renderer and its volumes at that moment
  };
  DrawnAhead Ahead;

  static void Draw(vtkVariationFieldVolumeMapper* mapper, vtkRenderer* renderer, vtkVolume* volume);
  static void DrawInOrder(
    vtkVariationFieldVolumeMapper* mapper, vtkRenderer* renderer, vtkVolume* volume);

  /// A volume whose shadows fall on geometry.
  struct Casting
  {
    vtkVariationFieldVolumeMapper* mapper;
    varimarch::Frame frame;
    std::optional<varimarch::PictureQuality> quality; ///< That of the image; none for a still one.
    varimarch::RayMarcher* marcher; ///< The one of the level that the image is drawn by.
  };
  std::optional<Casting> CastingOf(
    vtkVariationFieldVolumeMapper* mapper, vtkRenderer* renderer, vtkVolume* volume);

  // Dims the opaque geometry of a renderer by what all its volumes leave of the light, before any
  // of them is drawn.
  static void CastOnGeometry(
    vtkRenderer* renderer, const std::vector<vtkVolume*>& volumes, bool isBetweenLayers);

  // The same where volumes are drawn alone: between layers of translucent geometry, or into images.
  // The first volume of an image casts the shadows of all.
  static void CastBeforeFirst(
    vtkVariationFieldVolumeMapper* mapper, vtkRenderer* renderer, varimarch::RayPass pass);
  DrawnAhead Cast; ///< The image for which another mapper has cast the shadows of this one.
  double CastSeconds =
    0.0; ///< The time that this has taken for this volume, while a user interacts.

  varimarch::RayMarcher Marcher;
  varimarch::LevelOfDetail Levels;
  varimarch::RayMarcher* Last = &this->Marcher; ///< the one of the last frame

  /// The sum of a number over the marchers of both levels.
  template <class Number>
  auto Sum(Number number)
  {
    return std::invoke(number, this->Marcher) + std::invoke(number, this->Levels.Marcher());
  }

  std::string ReportedError; ///< the last error that was reported, so that it is not repeated
  std::string ReportedWarning;
  std::string ReportedNumbers; ///< the last sentences about replaced numbers
  varimarch::InteractiveQuality Quality;
  bool LastHasBuilt = false; ///< True if the last image while a user interacts built resources.

  // The quality of the next image; none for a still one.
  std::optional<varimarch::PictureQuality> QualityOf(
    vtkVariationFieldVolumeMapper* mapper, vtkVolume* volume, const varimarch::Frame& frame) const;

  void DrawInTime(
    vtkVariationFieldVolumeMapper* mapper, vtkVolume* volume, const varimarch::Frame& frame);
};

#endif
