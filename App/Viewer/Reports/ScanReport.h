#ifndef Varimarch_Viewer_ScanReport_h
#define Varimarch_Viewer_ScanReport_h

#include <QString>

namespace varimarch
{

struct Scene;
struct Study;
class SceneModel;

/// The report's words, with the pictures "picture", "axial", "coronal" and "sagittal". Names
/// neither the patient nor the file.
QString ScanReportHtml(const Scene& scene, const Study& study);

/// Writes what is shown as a PDF report: the picture, the slices, what they are drawn by, the error
/// that is promised, and what was measured.
/// @param model  has a volume
/// @throws std::runtime_error one sentence
void WriteScanReport(SceneModel* model, const QString& path);

}

#endif
