// Documents of several pages.
#pragma once

namespace carom {

class Canvas;

/// Ends the page that has been drawn on a PDF; what is drawn from then on is on the next one.
/// Throws SystemError.
void end_page(Canvas& document);

}  // namespace carom
