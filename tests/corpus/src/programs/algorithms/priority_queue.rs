//! A queue of bounded length that gives the most urgent first; equals in the order in which they came.

use bessemer::prelude::*;

/// Something to do.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Job {
    pub urgency: u8,
    pub number: u16,
}

/// Jobs, the most urgent last.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Queue {
    jobs: List<Job, 6>,
}

#[component]
impl Queue {
    /// Takes a job in; whether there was room.
    #[entry]
    pub fn put(&mut self, job: Job) -> bool {
        if self.jobs.len() == 6 {
            return false;
        }
        self.jobs.push(job);
        let mut at = self.jobs.len() - 1;
        #[bound(6)]
        while at > 0 && self.jobs[at - 1].urgency >= job.urgency {
            self.jobs[at] = self.jobs[at - 1];
            at -= 1;
        }
        self.jobs[at] = job;
        true
    }

    /// The most urgent job, taken out.
    #[entry(infallible)]
    pub fn take(&mut self) -> Option<Job> {
        self.jobs.pop()
    }
}
