#include "Viewer/Model/MeasureTexts.h"

#include "Scene/Measures/MeasureKinds.h"
#include "Scene/Model/Scene.h"
#include "Scene/Pipeline/ScenePicking.h"
#include "Scene/Volumes/VolumeLoading.h"
#include "Viewer/Model/Study.h"
#include "Viewer/Model/StudyTimes.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <map>

namespace varimarch
{

namespace
{

constexpr double Mm3PerMl = 1000.0;

QString FourDigits(double value)
{
  return QLocale().toString(value, 'g', 4);
}

// Both numbers have as many decimals as show three digits of the larger one.
QString MeanText(const RegionStatistics& statistics, const QString& unit)
{
  const double largest = std::max(std::abs(statistics.mean), statistics.standardDeviation);
  const bool isShorterAsPower = largest >= 1e6 || (largest > 0.0 && largest < 1e-6);
  const int decimals =
    largest > 0.0 && !isShorterAsPower ? std::max(2 - int(std::floor(std::log10(largest))), 0) : 2;
  const auto text = [=](double number)
  { return isShorterAsPower ? FourDigits(number) : NumberText(number, decimals); };
  return MeasureTexts::tr("mean %1 ± %2%3")
    .arg(text(statistics.mean), text(statistics.standardDeviation), unit);
}

QString RangeText(const RegionStatistics& statistics, const QString& unit)
{
  return MeasureTexts::tr("%1, from %2 to %3%4")
    .arg(MeanText(statistics, unit), FourDigits(statistics.smallest),
      FourDigits(statistics.largest), unit);
}

QString UnitText(const LoadedVolume& volume)
{
  const std::string unit = UnitOf(volume);
  return unit == "HU" ? MeasureTexts::tr(" HU")
    : unit.empty()    ? QString()
                      : ' ' + QString::fromStdString(unit);
}

QString AreaText(double areaMm2)
{
  constexpr double Mm2PerCm2 = 100.0;
  return areaMm2 < Mm2PerCm2 ? MeasureTexts::tr("%1 mm²").arg(NumberText(areaMm2, 1))
                             : MeasureTexts::tr("%1 cm²").arg(NumberText(areaMm2 / Mm2PerCm2, 2));
}

/// The texts of one measurement.
struct MeasureText
{
  QString value;
  QString label;
};

// A region has an area and pixels, or a volume and voxels.
MeasureText RegionTexts(const MeasureValues& values, const QString& unit)
{
  const RegionStatistics& statistics = *values.statistics;
  const bool isFlat = bool(values.areaMm2);
  const QString size = isFlat ? AreaText(*values.areaMm2) : VolumeText(*values.volumeMm3);
  if (statistics.voxels == 0)
  {
    const QString none = isFlat ? size : MeasureTexts::tr("no voxels");
    return { none, none };
  }
  const QString count =
    (isFlat ? MeasureTexts::tr("%1 pixels") : MeasureTexts::tr("%1 voxels")).arg(statistics.voxels);
  return { RangeText(statistics, unit) + '\n' + size + ", " + count,
    MeanText(statistics, unit) + '\n' + size };
}

MeasureText TextsOf(const MeasureValues& values, const QString& unit)
{
  if (values.statistics)
  {
    return RegionTexts(values, unit);
  }
  const QString text = values.lengthMm
    ? MeasureTexts::tr("%1 mm").arg(NumberText(*values.lengthMm, 1))
    : values.degrees ? MeasureTexts::tr("%1°").arg(NumberText(*values.degrees, 1))
                     : QString();
  return { text, text };
}

QString TitleOfOverlay(const PlacedVolume& overlay)
{
  const QString title = MeasureTexts::tr("Volume %1").arg(overlay.number);
  const std::string& modality = overlay.volume.modality;
  return modality.empty() ? title : title + " (" + QString::fromStdString(modality) + ')';
}

// Letters in an image have little room: the modality alone, if no other volume over the first one
// has it.
QString MarkOfOverlay(const PlacedVolume& overlay, const std::vector<PlacedVolume>& over)
{
  const std::string& modality = overlay.volume.modality;
  const auto count = std::count_if(over.begin(), over.end(),
    [&](const PlacedVolume& other) { return other.volume.modality == modality; });
  return modality.empty() || count > 1 ? TitleOfOverlay(overlay) : QString::fromStdString(modality);
}

// Adds a line for each volume over the first one with voxels in the region.
void AddOverlays(const Measure& measure, vtkImageData* image, const std::vector<PlacedVolume>& over,
  MeasureText& texts)
{
  for (const PlacedVolume& overlay : over)
  {
    const auto found = StatisticsOver(measure, image, overlay.image);
    if (found && found->voxels > 0)
    {
      const RegionStatistics statistics = InUnits(*found, overlay.volume);
      const QString unit = UnitText(overlay.volume);
      texts.value += '\n' + TitleOfOverlay(overlay) + ": " + RangeText(statistics, unit);
      texts.label += '\n' + MarkOfOverlay(overlay, over) + ": " + MeanText(statistics, unit);
    }
  }
}

// The value at a point: "HU 40", "SUV 2.35 (5868)" or "value 7".
QString ValueText(const LoadedVolume& volume, double value)
{
  const QString number = NumberText(value, 0);
  return volume.modality == "CT" ? MeasureTexts::tr("HU ") + number
    : volume.uptakeValueFactor > 0.0
    ? MeasureTexts::tr("SUV %1 (%2)").arg(NumberText(value * volume.uptakeValueFactor, 2), number)
    : MeasureTexts::tr("value ") + number;
}

// ", liver" in a visible segment of a volume that has this name, otherwise empty.
QString SegmentText(
  const Scene& scene, const Study& study, int volume, const std::array<double, 3>& pointMm)
{
  const auto& labels = SceneLabelsOf(scene, volume);
  if (!labels)
  {
    return {};
  }
  const auto numbers =
    Placed(StudyOfVolume(study, volume).labels->image, PlacementOf(scene, volume));
  std::array<double, 3> copy = pointMm; // VTK takes no constant
  const vtkIdType voxel = numbers->FindPoint(copy.data());
  const int number =
    voxel < 0 ? 0 : static_cast<const unsigned char*>(numbers->GetScalarPointer())[voxel];
  const bool isShown = number > 0 && labels->segments[number - 1].visible;
  return isShown ? ", " + QString::fromStdString(labels->segments[number - 1].name) : QString();
}

// "; PET: SUV 2.35 (5868)" for each visible volume over the first at a point.
QString OverlayTexts(const Scene& scene, const Study& study, const std::array<double, 3>& pointMm)
{
  QString texts;
  for (const PlacedVolume& overlay : VisibleOverlays(scene, study))
  {
    const int volume = overlay.number - 1;
    if (const auto value = ValueAt(overlay.image, pointMm))
    {
      texts += "; " + QString::fromStdString(scene.overlays[std::size_t(volume) - 1].name) + ": " +
        ValueText(overlay.volume, *value) + SegmentText(scene, study, volume, pointMm);
    }
  }
  return texts;
}

}

MeasureTexts::MeasureTexts(const Scene& scene, const Study& study, const MeasureTexts& earlier)
{
  const LoadedVolume& volume = study.volume;
  const std::vector<PlacedVolume> over = VisibleOverlays(scene, study);
  this->volumes.push_back({ 1, volume.image, {} });
  for (const PlacedVolume& other : over)
  {
    this->volumes.push_back(
      { other.number, other.volume.image, PlacementOf(scene, other.number - 1) });
  }
  const bool areSameVolumes = earlier.volumes == this->volumes;
  for (const Measure& measure : scene.measures)
  {
    const std::size_t number = this->known.size();
    if (areSameVolumes && earlier.AreKnown(number, measure))
    {
      this->known.push_back(earlier.known[number]);
    }
    else
    {
      MeasureText texts =
        TextsOf(InUnits(ValuesOf(measure, volume.image), volume), UnitText(volume));
      AddOverlays(measure, volume.image, over, texts);
      this->known.push_back({ measure.kind, measure.pointsMm, texts.value, texts.label });
    }
    const ValueTexts& texts = this->known.back();
    const QString name = QString::fromStdString(measure.name);
    const QString separator = name.isEmpty() || texts.label.isEmpty() ? "" : ": ";
    this->values.append(TraitsOf(measure.kind).hasWords ? name : texts.value);
    this->labels.append(name + separator + texts.label);
  }
}

bool MeasureTexts::AreKnown(std::size_t number, const Measure& measure) const
{
  return number < this->known.size() && this->known[number].kind == measure.kind &&
    this->known[number].pointsMm == measure.pointsMm;
}

std::vector<PlacedVolume> VisibleOverlays(const Scene& scene, const Study& study)
{
  std::vector<PlacedVolume> visible;
  for (std::size_t i = 0; i < scene.overlays.size(); ++i)
  {
    if (scene.overlays[i].visible)
    {
      const LoadedVolume& volume = study.overlays[i]->volume;
      visible.push_back({ int(i) + 2, volume, Placed(volume.image, scene.overlays[i].placement) });
    }
  }
  return visible;
}

QString TitleOf(MeasureKind kind)
{
  static const std::map<MeasureKind, const char*> titles = {
    { MeasureKind::Distance, QT_TRANSLATE_NOOP("MeasureTexts", "Distance") },
    { MeasureKind::Angle, QT_TRANSLATE_NOOP("MeasureTexts", "Angle") },
    { MeasureKind::CobbAngle, QT_TRANSLATE_NOOP("MeasureTexts", "Cobb angle") },
    { MeasureKind::Box, QT_TRANSLATE_NOOP("MeasureTexts", "Box") },
    { MeasureKind::Ellipse, QT_TRANSLATE_NOOP("MeasureTexts", "Ellipse") },
    { MeasureKind::Freehand, QT_TRANSLATE_NOOP("MeasureTexts", "Freehand region") },
    { MeasureKind::Curve, QT_TRANSLATE_NOOP("MeasureTexts", "Curve") },
    { MeasureKind::Arrow, QT_TRANSLATE_NOOP("MeasureTexts", "Arrow") },
    { MeasureKind::Text, QT_TRANSLATE_NOOP("MeasureTexts", "Text") },
  };
  return MeasureTexts::tr(titles.at(kind));
}

QString VolumeText(double volumeMm3)
{
  return volumeMm3 < Mm3PerMl ? MeasureTexts::tr("%1 mm³").arg(NumberText(volumeMm3, 0))
                              : MeasureTexts::tr("%1 ml").arg(NumberText(volumeMm3 / Mm3PerMl, 2));
}

QString RegionText(const RegionStatistics& statistics, const LoadedVolume& volume)
{
  return RegionTexts(
    { {}, {}, {}, statistics.volumeMm3, InUnits(statistics, volume) }, UnitText(volume))
    .value;
}

QString PointText(const Scene& scene, const Study& study, const std::array<double, 3>& pointMm)
{
  const LoadedVolume& volume = study.volume;
  return MeasureTexts::tr("%1 at %2, %3, %4 mm")
           .arg(ValueText(volume, ValueAt(volume.image, pointMm).value_or(0.0)))
           .arg(NumberText(pointMm[0], 1))
           .arg(NumberText(pointMm[1], 1))
           .arg(NumberText(pointMm[2], 1)) +
    SegmentText(scene, study, 0, pointMm) + OverlayTexts(scene, study, pointMm);
}

namespace
{

struct KeyImageTexts
{
  Q_DECLARE_TR_FUNCTIONS(KeyImageTexts)
};

}

QString TitleOf(const KeyImage& image)
{
  return image.name.empty() ? TitleOf(image.view) : QString::fromStdString(image.name);
}

QString TitleOf(KeyView view)
{
  switch (view)
  {
    case KeyView::Axial:
      return KeyImageTexts::tr("Axial slice");
    case KeyView::Coronal:
      return KeyImageTexts::tr("Coronal slice");
    case KeyView::Sagittal:
      return KeyImageTexts::tr("Sagittal slice");
    default:
      return KeyImageTexts::tr("Volume");
  }
}

bool IsAtTime(const KeyImage& image, const LoadedTimes& times)
{
  return image.time && times.AreSeveral() && *image.time < int(times.values.size());
}

QString TimeTextOf(const KeyImage& image, const LoadedTimes& times)
{
  return IsAtTime(image, times) ? TimeText(times, *image.time) : QString();
}

}
