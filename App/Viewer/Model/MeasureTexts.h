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

/// What was measured, as people read it: one text for each in the order of the scene. Made once
/// after an edit, since statistics take a look at voxels.
struct MeasureTexts
{
  Q_DECLARE_TR_FUNCTIONS(MeasureTexts)

public:
  MeasureTexts() = default;
  MeasureTexts(const Scene& scene, vtkImageData* image);

  QStringList distances; ///< "12.3 mm"
  QStringList angles;    ///< "45.0°"
  QStringList boxes;     ///< two lines: "312 ± 45, from 10 to 420", "1.23 ml, 1482 voxels"
  QStringList boxLabels; ///< the same in short, for pictures: "312 ± 45", "1.23 ml"
};

/// "1.23 ml", below a millilitre "123 mm³".
QString VolumeText(double volumeMm3);

}

#endif
