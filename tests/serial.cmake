# Tests that measure time run alone.
set_tests_properties(Profile.EqualHeavyRasterPassesReadEqual Profile.PassesRecordingAndWaitingAreTheWallTime
                     SkippingCost.ATenthOfTheScreenPaysAtMostAFifth SkippingCost.AnOpaqueSceneDoesNotPayForScattering
                     PlanPageInBrowser.ThreeHundredNodesAreLaidOutInLessThanThreeSeconds PROPERTIES RUN_SERIAL TRUE)
