#ifndef Varimarch_Viewer_MeasureTexts_h
#define Varimarch_Viewer_MeasureTexts_h

#include "Scene/Scene.h"

#include <QCoreApplication>
#include <QString>
#include <QStringList>

class vtkImageData;

namespace varimarch
{

struct BoxStatistics;

/// Texts of the measurements, one for each in the order of the scene. They are made once per edit,
/// since box statistics read many voxels.
struct MeasureTexts
{
  Q_DECLARE_TR_FUNCTIONS(MeasureTexts)

public:
  MeasureTexts() = default;
  MeasureTexts(const Scene& scene, vtkImageData* image);

  QStringList distances; ///< "12.3 mm"
  QStringList angles;    ///< "45.0°"
  QStringList boxes;     ///< two lines: "312 ± 45, from 10 to 420", "1.23 ml, 1482 voxels"
  QStringList boxLabels; ///< short form for images: "312 ± 45", "1.23 ml"
};

/// "1.23 ml", or "123 mm³" below one millilitre.
QString VolumeText(double volumeMm3);

}

#endif
