# fuzz targets: make fuzz
