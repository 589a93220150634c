#ifndef Varimarch_Viewer_MeasureTexts_h
#define Varimarch_Viewer_MeasureTexts_h

#include "Scene/Scene.h"

#include <QCoreApplication>
#include <QString>
#include <QStringList>

#include <array>

namespace varimarch
{

struct LoadedVolume;
struct RegionStatistics;
struct Study;

/// Texts of the measurements, one for each in the order of the scene. They are made once per edit,
/// since statistics read many voxels.
struct MeasureTexts
{
  Q_DECLARE_TR_FUNCTIONS(MeasureTexts)

public:
  MeasureTexts() = default;
  MeasureTexts(const Scene& scene, const LoadedVolume& volume);

  /// "12.3 mm", "45.0°", the words of annotations, or two lines: "mean 312 ± 45 HU, from 10 to
  /// 420 HU", "1.23 ml, 1482 voxels".
  QStringList values;
  /// For images: "aorta: 12.3 mm", without extremes and counts. They may be empty.
  QStringList labels;
};

/// The name of a kind of measurement: "Distance".
QString TitleOf(MeasureKind kind);

/// "1.23 ml", or "123 mm³" below one millilitre.
QString VolumeText(double volumeMm3);

/// The two lines of a region in MeasureTexts::values, or "no voxels".
QString RegionText(const RegionStatistics& statistics, const LoadedVolume& volume);

/// "HU 41 at 12.3, -4.0, 105.5 mm, liver" for a point in world space, the last in a visible
/// segment.
QString PointText(const Scene& scene, const Study& study, const std::array<double, 3>& pointMm);

}

#endif
