// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

class QPagedPaintDevice;
class QPaintDevice;
class QTextDocument;

namespace handwheel {

// A block that stays in one piece on paper. It is a paragraph with its pictures, or a row of a table. Positions are
// measured from the top of the document before it is divided into pages.
struct PrintedBlock {
  double top = 0.0, bottom = 0.0;
  bool beginsPage = false;
  bool staysWithNext = false;  // a heading
};

// The part of a document that is printed on one page, from one height to another.
struct PrintedPage {
  double from = 0.0, to = 0.0;
};

// Divides blocks, in their order from the top of the document, into pages of this height. A page ends between two
// blocks; only a block that is higher than a page is cut. O(blocks).
std::vector<PrintedPage> pagesOf(const std::vector<PrintedBlock>& blocks, double height);

// Prints a document with margins of 2 cm and page numbers. QTextDocument::print() would cut rows of tables between
// their lines. The document is laid out anew for the device. Pictures larger than the area between the margins are
// scaled down. newPage: the function that starts the next page of the device.
void printWholeRows(QTextDocument& document, QPaintDevice& device, const std::function<void()>& newPage);
void printWholeRows(QTextDocument& document, QPagedPaintDevice& device);

}  // namespace handwheel
