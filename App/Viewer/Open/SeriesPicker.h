#ifndef Varimarch_Viewer_SeriesPicker_h
#define Varimarch_Viewer_SeriesPicker_h

#include "Scene/VolumeLoading.h"

#include <QDialog>

#include <vector>

class QListWidget;

namespace varimarch
{

/// Asks which of several DICOM series to open: each with the picture of its middle slice and what
/// is known of it. The first, which is the largest, is chosen by Return alone.
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
