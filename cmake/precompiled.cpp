// The source of the targets whose headers are precompiled: it holds nothing.
