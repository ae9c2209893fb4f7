// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "volume/image/ImageFile.h"

namespace handwheel {

// Reads an image in NIfTI-1 or NIfTI-2 (nifti.nimh.nih.gov; nifti1.h, nifti2.h). The file is .nii, plain or packed by
// gzip, of either byte order. The grid is that of the sform if there is one, or else of the qform, or else of the
// spacings. It is converted from the coordinates of NIfTI (x to the right, y to the front) to those of ImageGrid.
// Values are scaled by scl_slope and scl_inter. Only the first image of a time series is read. The intent of labels
// is kept, and so are their names (NiftiLabels.h). A sform and a qform that contradict each other cause a remark.
// Errors: HeaderMalformed, ElementMalformed {field, problem}, Unsupported (pairs of .hdr and .img, colours, complex
// numbers), and the errors of imageOfBytes() and inflated().
Result<ImageFile> readNifti(std::string_view bytes);

// Returns true if a file that begins with these bytes, unpacked if necessary, is in NIfTI.
bool looksLikeNifti(std::string_view bytes);

}  // namespace handwheel
