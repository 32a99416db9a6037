# Tests that measure time run alone.
set_tests_properties(Profile.EqualHeavyRasterPassesReadEqual Profile.PassesRecordingAndWaitingAreTheWallTime PROPERTIES RUN_SERIAL TRUE)
