#include "Viewer/Reports/PdfPages.h"

#include "Scene/OutputFile.h"

#include <QAbstractTextDocumentLayout>
#include <QCoreApplication>
#include <QDateTime>
#include <QFile>
#include <QLocale>
#include <QPainter>
#include <QPdfWriter>
#include <QTextDocument>

namespace varimarch
{

namespace
{

constexpr int DotsPerInch = 150;
constexpr double MarginMm = 18.0;
constexpr double FootHeight = 40.0; // [dots]

void PaintFoot(QPainter& painter, const QSizeF& page, int number, int count)
{
  const QRectF foot(0.0, page.height() + 0.25 * FootHeight, page.width(), 0.75 * FootHeight);
  painter.setPen(Qt::darkGray);
  painter.drawText(foot, Qt::AlignLeft | Qt::AlignVCenter,
    QCoreApplication::translate(
      "PdfPages", "Not for diagnostic use: made by a program that is not a medical device"));
  painter.drawText(
    foot, Qt::AlignRight | Qt::AlignVCenter, QStringLiteral("%1 / %2").arg(number).arg(count));
}

void PaintPages(QTextDocument& document, QPdfWriter& writer)
{
  QPainter painter(&writer);
  const QSizeF page(writer.width(), writer.height() - FootHeight);
  document.documentLayout()->setPaintDevice(&writer);
  document.setDocumentMargin(0.0);
  document.setPageSize(page);
  for (int i = 0; i < document.pageCount(); ++i)
  {
    if (i > 0)
    {
      writer.newPage();
    }
    painter.save();
    painter.translate(0.0, -i * page.height());
    document.drawContents(&painter, QRectF(0.0, i * page.height(), page.width(), page.height()));
    painter.restore();
    PaintFoot(painter, page, i + 1, document.pageCount());
  }
}

}

void WritePdf(QTextDocument& document, const QString& title, const QString& path)
{
  WriteFileWhole(path.toStdString(),
    [&](const std::string& part)
    {
      QFile file(QString::fromStdString(part));
      if (!file.open(QIODevice::WriteOnly))
      {
        return false;
      }
      {
        QPdfWriter writer(&file);
        writer.setTitle(title);
        writer.setCreator("Varimarch");
        writer.setPageSize(QPageSize(QPageSize::A4));
        writer.setPageMargins(
          QMarginsF(MarginMm, MarginMm, MarginMm, MarginMm), QPageLayout::Millimeter);
        writer.setResolution(DotsPerInch);
        PaintPages(document, writer);
      }
      // QPdfWriter reports no errors; those of the file remain set.
      return file.flush() && file.error() == QFile::NoError;
    });
}

QString OriginHtml()
{
  return QStringLiteral("<p>Varimarch %1, %2</p>")
    .arg(QCoreApplication::applicationVersion(),
      QLocale().toString(QDateTime::currentDateTime(), QLocale::ShortFormat));
}

}
