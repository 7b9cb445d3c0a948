# HAND.csv, a millisecond a line, from places that the hand goes between in straight lines.

FNR > 1 {
    n = FNR - 1
    t[n] = $1; x[n] = $2; y[n] = $3; angle[n] = $4
}

END {
    print "t_s,x_m,y_m,angle_rad"
    k = 1
    for (i = 0; i <= t[n] * 1000; i++) {
        s = i / 1000
        while (k < n - 1 && s > t[k + 1]) k++
        share = (s - t[k]) / (t[k + 1] - t[k])
        printf "%.3f,%.7f,%.7f,%.7f\n", s, (x[k] + share * (x[k + 1] - x[k])) / 1000, (y[k] + share * (y[k + 1] - y[k])) / 1000, \
            (angle[k] + share * (angle[k + 1] - angle[k])) * atan2(0, -1) / 180
    }
}
