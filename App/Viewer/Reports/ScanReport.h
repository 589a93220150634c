#ifndef Varimarch_Viewer_ScanReport_h
#define Varimarch_Viewer_ScanReport_h

#include <QString>

namespace varimarch
{

struct Scene;
struct Study;
class SceneModel;

/// HTML of the report, which refers to the images "picture", "axial", "coronal" and "sagittal".
/// Names neither the patient nor the file.
QString ScanReportHtml(const Scene& scene, const Study& study);

/// Writes a PDF report with the rendered image, the slices, the settings, the promised error and
/// the measurements.
/// @param model  has a volume
/// @throws std::runtime_error with one sentence
void WriteScanReport(SceneModel* model, const QString& path);

}

#endif
