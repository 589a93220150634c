#ifndef Varimarch_Viewer_PdfPages_h
#define Varimarch_Viewer_PdfPages_h

#include <QString>

class QTextDocument;

namespace varimarch
{

/// Writes a document as A4 pages whose footer has the notice that it is not for diagnostic use, and
/// the page number. The file is never left incomplete.
/// @throws std::runtime_error with one sentence that names the file
void WritePdf(QTextDocument& document, const QString& title, const QString& path);

/// A line of HTML with program version and time: "Varimarch 0.1, 22 Nov 2026 21:08".
QString OriginHtml();

}

#endif
