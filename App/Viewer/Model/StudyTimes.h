#ifndef Varimarch_Viewer_StudyTimes_h
#define Varimarch_Viewer_StudyTimes_h

#include "Scene/Volumes/VolumeLoading.h"
#include "Viewer/Model/Study.h"

#include <QString>

#include <array>
#include <memory>
#include <string>
#include <vector>

namespace varimarch
{

struct Scene;

/// Reads the times of a volume, all of the same size, within the memory that the user lets the
/// program use.
class SizedTimes
{
public:
  /// @param volume  the number of a volume of the scene, which is a file
  /// @param shown   that volume at one of its times
  SizedTimes(const Scene& scene, int volume, const LoadedVolume& shown);

  /// The volume at a time.
  /// @param observer  as for LoadVolume
  /// @throws std::runtime_error with one sentence if it is cancelled, the file cannot be read, or
  ///         the time has another size than the others: labels, cuts and masks lie on their grid
  LoadedVolume Read(int time, const LoadObserver& observer);

private:
  /// Voxels along each axis, and components of each.
  using Size = std::array<int, 4>;

  static Size SizeOf(const LoadedVolume& volume);

  TimeReader reader;
  Size size;
};

struct Scene;
class SceneModel;

/// Reads the times of a scan for images in files, together with those of the volumes over it that
/// follow them. A volume over it whose time cannot be read stays at the time before, as in the
/// window.
class StudyTimes
{
public:
  StudyTimes(const Scene& scene, std::shared_ptr<const Study> study);

  /// The study at a time.
  /// @param observer  as for LoadVolume
  /// @throws std::runtime_error with one sentence if it is cancelled or the scan cannot be read
  std::shared_ptr<const Study> Read(int time, const LoadObserver& observer = {});

  /// Why a volume over the scan stayed at the time before, for the first time that this happened;
  /// empty if none did.
  const std::string& Problem() const { return this->problem; }

private:
  void ReadVolume(int volume, int time, const LoadObserver& observer);

  std::string problem;
  std::shared_ptr<const Study> study;               ///< at the time that was read last
  std::vector<std::unique_ptr<SizedTimes>> readers; ///< one per volume; null if it stays
};

/// The study of a model at the time that its scene names, for images and numbers in files: the
/// window may still show the time before.
/// @throws std::runtime_error with one sentence
std::shared_ptr<const Study> ShownStudy(const SceneModel& model);

/// How fast the times of a scan follow each other.
struct TimeSpeed
{
  double timesPerSecond = 0.0; ///< 0: as they were acquired, which needs times in seconds

  bool IsAsAcquired() const { return this->timesPerSecond == 0.0; }
};

/// Seconds from one time to the next. The last one stays as long as that before it.
/// @param times  several; in seconds if the speed is that of acquisition
double SecondsOfTime(const LoadedTimes& times, int time, TimeSpeed speed);

/// The times that the pictures of a movie show, counted from 0. Each time is shown at least once.
/// @throws std::runtime_error with one sentence if the movie would last more than an hour
std::vector<int> TimesOfMovie(const LoadedTimes& times, TimeSpeed speed, double picturesPerSecond);

/// A time with its unit and its number, such as "1.40 s, 3 of 20".
QString TimeText(const LoadedTimes& times, int time);

struct FileSource;

/// The memory that the user lets the program use for volumes [GB], kept in the settings; 0: all of
/// the computer's.
int ChosenMemoryGigabytes();
void ChooseMemoryGigabytes(int gigabytes);

/// A file that is to be read within that memory, unless it states its own. Scenes do not keep the
/// user's, which belongs to this computer.
FileSource WithinMemory(FileSource file);

}

#endif
