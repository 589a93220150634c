#ifndef Varimarch_Viewer_MeasureTexts_h
#define Varimarch_Viewer_MeasureTexts_h

#include "Scene/Model/Scene.h"
#include "Scene/Volumes/Placing.h"

#include <QCoreApplication>
#include <QLocale>
#include <QString>
#include <QStringList>

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include <array>
#include <vector>

namespace varimarch
{

struct LoadedVolume;
struct RegionStatistics;
struct Study;

/// Texts of the measurements, one for each in the order of the scene.
class MeasureTexts
{
  Q_DECLARE_TR_FUNCTIONS(MeasureTexts)

public:
  MeasureTexts() = default;

  /// @param earlier  texts whose values are kept where volumes and measurement are the same, since
  /// statistics read many voxels
  MeasureTexts(
    const Scene& scene, const Study& study, const MeasureTexts& earlier = MeasureTexts());

  /// "12.3 mm", "45.0°", the words of annotations, or two lines: "mean 312 ± 45 HU, from 10 to
  /// 420 HU", "1.23 ml, 1482 voxels". A line follows for each visible volume over the first one
  /// with voxels there: "Volume 2 (PT): mean 2.1 ± 0.3 SUV, from 1.2 to 3.4 SUV". Names of volumes
  /// are left out, since texts are in exported images, and names may be those of patients.
  QStringList values;
  /// For images: "aorta: 12.3 mm", without extremes and counts. They may be empty.
  QStringList labels;

private:
  /// The texts of the values of a measurement, without its name.
  struct ValueTexts
  {
    MeasureKind kind;
    std::vector<std::array<double, 3>> pointsMm;
    QString value;
    QString label;
  };

  /// A volume that was measured.
  struct Measured
  {
    int number;
    vtkSmartPointer<vtkImageData> image;
    Placement placement;

    bool operator==(const Measured& other) const
    {
      return this->number == other.number && this->image == other.image &&
        this->placement == other.placement;
    }
  };

  bool AreKnown(std::size_t number, const Measure& measure) const;

  std::vector<Measured> volumes;
  std::vector<ValueTexts> known;
};

/// The visible volumes over the first one. The study must outlive them.
std::vector<PlacedVolume> VisibleOverlays(const Scene& scene, const Study& study);

/// The name of a kind of measurement: "Distance".
QString TitleOf(MeasureKind kind);

/// "1.23 ml", or "123 mm³" below one millilitre.
QString VolumeText(double volumeMm3);

/// The two lines of a region in MeasureTexts::values, or "no voxels".
QString RegionText(const RegionStatistics& statistics, const LoadedVolume& volume);

/// "HU 41 at 12.3, -4.0, 105.5 mm, liver" for a point in world space, the last in a visible
/// segment.
QString PointText(const Scene& scene, const Study& study, const std::array<double, 3>& pointMm);

struct LoadedTimes;

/// The name of a key image, or the view that it shows: "Axial slice".
QString TitleOf(const KeyImage& image);

/// "Axial slice".
QString TitleOf(KeyView view);

/// True if the volume has the time that a key image names.
bool IsAtTime(const KeyImage& image, const LoadedTimes& times);

/// The time of a key image, as TimeText writes it; empty unless the volume has it.
QString TimeTextOf(const KeyImage& image, const LoadedTimes& times);

/// A number for display, written as in the user's language. Files hold numbers as in C.
inline QString NumberText(double number, int decimals)
{
  return QLocale().toString(number, 'f', decimals);
}

}

#endif
