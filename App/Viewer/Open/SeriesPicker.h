#ifndef Varimarch_Viewer_SeriesPicker_h
#define Varimarch_Viewer_SeriesPicker_h

#include "Scene/Volumes/VolumeLoading.h"

#include <QDialog>

#include <vector>

class QListWidget;

namespace varimarch
{

/// Asks which of several DICOM series to open. Each is shown with its middle slice and its
/// description. The first one, which is the largest, is preselected.
class SeriesPicker : public QDialog
{
  Q_OBJECT

public:
  SeriesPicker(std::vector<SeriesSummary> series, QWidget* parent);

signals:
  void Chosen(const QString& uid);

private:
  void Add(const SeriesSummary& summary);
  void Choose();

  std::vector<SeriesSummary> series;
  QListWidget* list;
};

}

#endif
