# Tests that measure time run alone.
set_tests_properties(Profile.EqualHeavyRasterPassesReadEqual Profile.PassesRecordingAndWaitingAreTheWallTime
                     SkippingCost.ATenthOfTheScreenPaysAtMostAFifth SkippingCost.AnOpaqueSceneDoesNotPayForScattering
                     PlanPageInBrowser.ThreeHundredNodesAreLaidOutInLessThanThreeSeconds
                     CompareTimings.SeesTwiceTheWorkAndNothingElse ProfiledTrace.AddsUpToTheWallTimeOfEachFrame PROPERTIES RUN_SERIAL TRUE)
