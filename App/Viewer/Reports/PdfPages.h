#ifndef Varimarch_Viewer_PdfPages_h
#define Varimarch_Viewer_PdfPages_h

#include <QString>

class QTextDocument;

namespace varimarch
{

/// Writes a document as A4 pages, each with the notice that it is not for diagnostic use and its
/// number at the foot; complete or not at all.
/// @throws std::runtime_error one sentence that names the file
void WritePdf(QTextDocument& document, const QString& title, const QString& path);

/// "Varimarch 0.1, 22 Nov 2026 21:08", as a line of HTML.
QString OriginHtml();

}

#endif
