#ifndef Varimarch_Viewer_ScanReport_h
#define Varimarch_Viewer_ScanReport_h

#include "Scene/Model/Scene.h"
#include "Viewer/Model/BackgroundTask.h"
#include "Viewer/Model/Study.h"

#include <QString>

#include <string>
#include <vector>

class QTextDocument;

namespace varimarch
{

class SceneModel;

/// HTML of the report, which refers to the images "picture", "axial", "coronal" and "sagittal".
/// Names neither the patient nor the file.
QString ScanReportHtml(const Scene& scene, const Study& study);

/// Writes a PDF report with the rendered image, the slices, the settings, the promised error and
/// the measurements.
/// @param model  has a volume
/// @throws std::runtime_error with one sentence
void WriteScanReport(SceneModel* model, const QString& path);

/// Writes a document as A4 pages whose footer has the notice that it is not for diagnostic use, and
/// the page number. The file is never left incomplete.
/// @throws std::runtime_error with one sentence that names the file
void WritePdf(QTextDocument& document, const QString& title, const QString& path);

/// A line of HTML with program version and time: "Varimarch 0.1, 22 Nov 2026 21:08".
QString OriginHtml();

/// The measurements of a scene as a DICOM structured report of one of its scans. It holds copies,
/// so that a thread may write it. Reports are of the scan whose look is edited: it may be the only
/// one with a patient.
class MeasureReport
{
public:
  /// True if reports can refer to a volume: it is a scan with a frame of reference, as only DICOM
  /// has, in a series of files.
  static bool IsPossible(const Scene& scene, const Study& study, int volume);

  /// @param shown   the study at the time that the scene names
  /// @param volume  the number of a volume for which a report is possible
  /// @throws std::runtime_error with a sentence if a box lies along other axes than the scan
  MeasureReport(const Scene& scene, const Study& shown, int volume);

  /// Writes the report into a new file.
  /// @throws std::runtime_error with a sentence
  void Write(const std::string& path, const TaskProgress& goesOn) const;

private:
  FileSource scan;
  LoadedVolume volume;
  std::vector<Measure> measures; ///< in the coordinates of the scan's patient
};

}

#endif
