#ifndef Varimarch_Viewer_MeasureReport_h
#define Varimarch_Viewer_MeasureReport_h

#include "Scene/Scene.h"
#include "Viewer/Model/BackgroundTask.h"
#include "Viewer/Model/Study.h"

#include <string>
#include <vector>

namespace varimarch
{

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
