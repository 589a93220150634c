#include "Viewer/TransferFunctionEditor/EditorReading.h"

#include "Viewer/TransferFunctionEditor/HistogramBars.h"

#include <QCoreApplication>
#include <QLocale>

#include <numeric>

namespace varimarch
{

namespace
{

// A class, since lupdate finds only the texts that are arguments of tr.
class ReadingTexts
{
  Q_DECLARE_TR_FUNCTIONS(TransferFunctionEditor)
};

QString ValueText(const EditorPicture& picture, double value)
{
  const int decimals = picture.layout.axis.Decimals();
  return picture.unit + ' ' + QLocale().toString(value, 'f', decimals);
}

QString OpacityText(double opacity)
{
  return ReadingTexts::tr("opacity %1")
    .arg(QLocale().toString(opacity, 'f', opacity < 0.1 ? 3 : 2));
}

QString PercentText(double part)
{
  const double percent = 100.0 * part;
  if (percent > 0.0 && percent < 0.01)
  {
    return QStringLiteral("< ") + QLocale().toString(0.01, 'f', 2);
  }
  return QLocale().toString(percent, 'f', percent >= 10.0 ? 0 : percent >= 1.0 ? 1 : 2);
}

QString CountsText(const EditorPicture& picture, double value)
{
  const HistogramBars bars(*picture.statistics, BarPixels * picture.layout.axis.ValuePerPixel());
  const std::vector<std::int64_t>& counts = picture.statistics->Counts();
  const double all = double(std::accumulate(counts.begin(), counts.end(), std::int64_t(0)));
  std::int64_t above = 0;
  for (std::size_t bin = 0; bin < counts.size(); ++bin)
  {
    const double binValue = picture.statistics->Smallest() + bin * picture.statistics->BinSpacing();
    above += binValue > value ? counts[bin] : 0;
  }
  return ReadingTexts::tr("%1 % of voxels, %2 % above")
    .arg(PercentText(bars.At(value).count / all), PercentText(above / all));
}

}

QString ReadingAt(const EditorPicture& picture, const QPointF& position)
{
  const std::optional<NodeId> node =
    picture.layout.NodeAt(picture.look, position, picture.selected);
  const double value =
    node ? ValueOf(picture.look, *node) : picture.layout.axis.ToValue(position.x());
  const bool ofNode = node && node->kind != NodeKind::Color;
  QStringList parts{ ValueText(picture, value) };
  if (ofNode || picture.look.blend != Blend::Isosurface)
  {
    parts.append(OpacityText(
      ofNode ? OpacityOf(picture.look, *node) : FunctionOf(picture.look).Opacity(value)));
  }
  if (picture.statistics)
  {
    parts.append(CountsText(picture, value));
  }
  return parts.join(", ");
}

QString DescriptionOf(const EditorPicture& picture, const NodeId& node)
{
  const QString value = ValueText(picture, ValueOf(picture.look, node));
  if (node.kind == NodeKind::Opacity)
  {
    return ReadingTexts::tr("point %1 of %2, %3, %4")
      .arg(node.index + 1)
      .arg(picture.look.opacities.size())
      .arg(value, OpacityText(OpacityOf(picture.look, node)));
  }
  if (node.kind == NodeKind::Surface)
  {
    return ReadingTexts::tr("surface %1 of %2, %3, %4")
      .arg(node.index + 1)
      .arg(picture.look.isosurfaces.size())
      .arg(value, OpacityText(OpacityOf(picture.look, node)));
  }
  return ReadingTexts::tr("colour %1 of %2, %3")
    .arg(node.index + 1)
    .arg(picture.look.colors.size())
    .arg(value);
}

}
