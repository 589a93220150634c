#ifndef Varimarch_Testing_TaskScans_h
#define Varimarch_Testing_TaskScans_h

#include "Module/Files/PhantomFiles.h"

#include <string>
#include <vector>

/// The scans of a patient who does not exist, as folders of DICOM files: a CT of the chest with a
/// nodule in the left lung and a table below, the same after the nodule has grown, and a PET in
/// which it and the heart are hot.
class TaskScans
{
public:
  TaskScans();

  std::string Ct() const { return this->folder.Path("ct"); }
  std::string LaterCt() const { return this->folder.Path("later"); }
  std::string Pet() const { return this->folder.Path("pet"); }
  /// A path for a file that the user saves.
  std::string Path(const std::string& name) const { return this->folder.Path(name); }

  /// The middle of the nodule, in LPS [mm].
  static glm::dvec3 Nodule();
  /// Points of the descending aorta in one coronal plane, from above, in LPS [mm].
  static std::vector<glm::dvec3> Aorta();

private:
  TemporaryFolder folder;
};

#endif
