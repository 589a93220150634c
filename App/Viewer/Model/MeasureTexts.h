#ifndef Varimarch_Viewer_MeasureTexts_h
#define Varimarch_Viewer_MeasureTexts_h

#include "Scene/Scene.h"

#include <QCoreApplication>
#include <QString>
#include <QStringList>

namespace varimarch
{

struct LoadedVolume;

/// Texts of the measurements, one for each in the order of the scene. They are made once per edit,
/// since box statistics read many voxels.
struct MeasureTexts
{
  Q_DECLARE_TR_FUNCTIONS(MeasureTexts)

public:
  MeasureTexts() = default;
  MeasureTexts(const Scene& scene, const LoadedVolume& volume);

  QStringList distances; ///< "12.3 mm"
  QStringList angles;    ///< "45.0°"
  /// Two lines: "mean 312 ± 45 HU, from 10 to 420 HU", "1.23 ml, 1482 voxels".
  QStringList boxes;
  QStringList boxLabels; ///< short form for images: "mean 312 ± 45 HU", "1.23 ml"
};

/// "1.23 ml", or "123 mm³" below one millilitre.
QString VolumeText(double volumeMm3);

}

#endif
